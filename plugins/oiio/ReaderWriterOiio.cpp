#include "ImageConversion.h"

#include <OpenImageIO/imageio.h>
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/ReaderWriter>
#include <osgDB/Registry>

/** Reads and writes images through OpenImageIO: .exr, .hdr, .tif and every other format that it supports.
 * Floating-point pixels keep their precision.
 *
 * OSG finds this plugin automatically for .exr. For formats that OSG has its own plugin for, append `.oiio` to the file
 * name (`probe.hdr.oiio`), or load this plugin first (`osgviewer -e oiio ...`). */
class ReaderWriterOiio : public osgDB::ReaderWriter
{
public:
    ReaderWriterOiio()
    {
        supportsExtension("oiio", "Pseudo-loader: reads the file named before it with OpenImageIO");
        for (const auto& [format, extensions] : OIIO::get_extension_map())
            for (const std::string& extension : extensions)
                supportsExtension(extension, format + " through OpenImageIO");
    }

    const char* className() const override { return "OpenImageIO image reader and writer"; }

    ReadResult readObject(const std::string& name, const Options* options) const override
    {
        return readImage(name, options);
    }

    ReadResult readImage(const std::string& name, const Options* options) const override
    {
        if (!acceptsExtension(osgDB::getLowerCaseFileExtension(name))) return ReadResult::FILE_NOT_HANDLED;
        const std::string fileName = osgDB::findDataFile(withoutPseudoExtension(name), options);
        if (fileName.empty()) return ReadResult::FILE_NOT_FOUND;
        std::string error;
        const osg::ref_ptr<osg::Image> image = readWithOiio(fileName, error);
        return image ? ReadResult(image.get()) : ReadResult(error);
    }

    WriteResult writeObject(const osg::Object& object, const std::string& name, const Options* options) const override
    {
        const auto* image = dynamic_cast<const osg::Image*>(&object);
        return image ? writeImage(*image, name, options) : WriteResult(WriteResult::FILE_NOT_HANDLED);
    }

    WriteResult writeImage(const osg::Image& image, const std::string& name, const Options*) const override
    {
        if (!acceptsExtension(osgDB::getLowerCaseFileExtension(name))) return WriteResult::FILE_NOT_HANDLED;
        const std::string error = writeWithOiio(image, withoutPseudoExtension(name));
        return error.empty() ? WriteResult(WriteResult::FILE_SAVED) : WriteResult(error);
    }

private:
    static std::string withoutPseudoExtension(const std::string& name)
    {
        return osgDB::getLowerCaseFileExtension(name) == "oiio" ? osgDB::getNameLessExtension(name) : name;
    }
};

REGISTER_OSGPLUGIN(oiio, ReaderWriterOiio)
