#include "AssimpTextures.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <utility>

#include <osg/Notify>
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/ReadFile>
#include <osgDB/Registry>

namespace
{

/** The extension of an encoded picture's format, by its first bytes or the name that the file gives it. */
std::string findEncoding(std::string_view bytes, const std::string& named)
{
    using namespace std::string_view_literals;
    if (bytes.starts_with("\x89PNG"sv)) return "png";
    if (bytes.starts_with("\xff\xd8\xff"sv)) return "jpg";
    return named;
}

/** Whether the chunks of a .png file lead to its end. OSG's reader takes seconds for a chunk that is too long. */
bool isCompletePng(std::string_view bytes)
{
    constexpr std::size_t AROUND = 12; // length, type and check sum
    std::size_t place = 8;             // after the signature
    while (place + AROUND <= bytes.size())
    {
        std::size_t length = 0;
        for (std::size_t byte = 0; byte < 4; ++byte)
            length = length << 8 | static_cast<unsigned char>(bytes[place + byte]);
        if (length > bytes.size() - place - AROUND) return false;
        if (bytes.substr(place + 4, 4) == "IEND") return true;
        place += AROUND + length;
    }
    return false;
}

osg::ref_ptr<osg::Image> decode(std::string_view bytes, const std::string& named, std::string& error)
{
    const std::string extension = findEncoding(bytes, named);
    if (extension == "png" && !isCompletePng(bytes))
    {
        error = "it is damaged; expected a complete .png picture";
        return nullptr;
    }
    osgDB::Registry* registry = osgDB::Registry::instance();
    registry->loadLibrary(registry->createLibraryNameForExtension(extension));
    // Not every reader of a format reads streams.
    for (const osg::ref_ptr<osgDB::ReaderWriter>& reader : registry->getReaderWriterList())
    {
        if (!reader->acceptsExtension(extension)) continue;
        std::istringstream stream{std::string(bytes)};
        osgDB::ReaderWriter::ReadResult result = reader->readImage(stream);
        if (result.validImage()) return result.getImage();
    }
    error = "no reader accepts it; expected a complete picture, such as a .png or .jpg";
    return nullptr;
}

/** Copy texels that the file holds without encoding; their first row is the upper one. */
osg::ref_ptr<osg::Image> copyTexels(const aiTexture& texture)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(static_cast<int>(texture.mWidth), static_cast<int>(texture.mHeight), 1, GL_RGBA,
                         GL_UNSIGNED_BYTE);
    const aiTexel* texel = texture.pcData;
    for (unsigned int row = texture.mHeight; row-- > 0;)
        for (unsigned int column = 0; column < texture.mWidth; ++column, ++texel)
        {
            unsigned char* pixel = image->data(column, row);
            pixel[0] = texel->r;
            pixel[1] = texel->g;
            pixel[2] = texel->b;
            pixel[3] = texel->a;
        }
    return image;
}

osg::ref_ptr<osg::Image> readEmbedded(const aiTexture& texture, std::string& error)
{
    if (texture.mHeight > 0) return copyTexels(texture);
    return decode({reinterpret_cast<const char*>(texture.pcData), texture.mWidth}, texture.achFormatHint, error);
}

/** Replace the escapes of a URI, such as %20, by their characters. */
std::string unescape(const std::string& reference)
{
    std::string text;
    for (std::size_t place = 0; place < reference.size(); ++place)
    {
        const std::string digits = reference[place] == '%' ? reference.substr(place + 1, 2) : std::string();
        if (digits.size() == 2 && digits.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos)
        {
            text += static_cast<char>(std::strtol(digits.c_str(), nullptr, 16));
            place += 2;
        }
        else
            text += reference[place];
    }
    return text;
}

} // namespace

AssimpTextures::AssimpTextures(const aiScene& scene, std::string name, const osgDB::Options& options) :
    _scene(scene), _name(std::move(name)), _options(&options)
{
}

osg::ref_ptr<osg::Image> AssimpTextures::read(const std::string& reference)
{
    const auto [place, isNew] = _images.try_emplace(reference);
    if (!isNew) return place->second;
    std::string error;
    const aiTexture* embedded = _scene.GetEmbeddedTexture(reference.c_str());
    place->second = embedded ? readEmbedded(*embedded, error) : readFile(reference, error);
    if (!place->second)
        OSG_WARN << "osgLego: '" << _name << "': can't read its texture '" << reference << "': " << error << std::endl;
    return place->second;
}

/** Find a picture by its path, as it is written or without escapes, or else by its simple name. An application's
 * osgDB::FindFileCallback, which may find files that OSG does not, is asked for only one form of the path. */
std::string AssimpTextures::find(const std::string& path) const
{
    osgDB::Registry* registry = osgDB::Registry::instance();
    const bool isWritten = !registry->findDataFileImplementation(path, _options, osgDB::CASE_SENSITIVE).empty();
    const std::string name = isWritten ? path : unescape(path);
    const std::string found = osgDB::findDataFile(name, _options);
    const std::string simpleName = osgDB::getSimpleFileName(name);
    if (!found.empty() || simpleName == name) return found;
    return osgDB::findDataFile(simpleName, _options); // paths may be those of the machine that wrote the file
}

osg::ref_ptr<osg::Image> AssimpTextures::readFile(const std::string& reference, std::string& error) const
{
    std::string path = reference;
    std::replace(path.begin(), path.end(), '\\', '/');
    if (path.starts_with("//")) path.erase(0, 2); // Blender's prefix of relative paths
    const std::string found = find(path);
    if (found.empty())
    {
        error = "there is no such file in the folder of the model or in osgDB's path";
        return nullptr;
    }
    osg::ref_ptr<osg::Image> image = osgDB::readRefImageFile(found, _options);
    if (!image) error = "'" + found + "' is not a picture that osgDB reads";
    return image;
}
