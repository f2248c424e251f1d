#include "LocalReading.h"

#include <string>

#include <osgDB/Callbacks>
#include <osgDB/FileUtils>
#include <osgDB/Registry>

namespace osgLego
{

namespace
{

using Result = osgDB::ReaderWriter::ReadResult;

/** Refuses addresses, before OSG looks for a plugin: curl reads some, and FFmpeg others. */
class LocalReader : public osgDB::ReadFileCallback
{
public:
    Result readObject(const std::string& name, const osgDB::Options* options) override
    {
        return isAddress(name) ? refuse(name, options) : ReadFileCallback::readObject(name, options);
    }

    Result readImage(const std::string& name, const osgDB::Options* options) override
    {
        return isAddress(name) ? refuse(name, options) : ReadFileCallback::readImage(name, options);
    }

    Result readHeightField(const std::string& name, const osgDB::Options* options) override
    {
        return isAddress(name) ? refuse(name, options) : ReadFileCallback::readHeightField(name, options);
    }

    Result readNode(const std::string& name, const osgDB::Options* options) override
    {
        return isAddress(name) ? refuse(name, options) : ReadFileCallback::readNode(name, options);
    }

    Result readShader(const std::string& name, const osgDB::Options* options) override
    {
        return isAddress(name) ? refuse(name, options) : ReadFileCallback::readShader(name, options);
    }

    Result readScript(const std::string& name, const osgDB::Options* options) override
    {
        return isAddress(name) ? refuse(name, options) : ReadFileCallback::readScript(name, options);
    }

    Result openArchive(const std::string& name, osgDB::ReaderWriter::ArchiveStatus status, unsigned int blockSize,
                       const osgDB::Options* options) override
    {
        return isAddress(name) ? refuse(name, options)
                               : ReadFileCallback::openArchive(name, status, blockSize, options);
    }

private:
    static bool isAddress(const std::string& name) { return name.find("://") != std::string::npos; }

    static Result refuse(const std::string& name, const osgDB::Options* options)
    {
        osgDB::findDataFile(name, options); // in vain, so that InputFiles tells of it
        return Result("osglegocapture does not use the network; expected a file");
    }
};

} // namespace

void keepReadingLocal()
{
    osgDB::Registry::instance()->setReadFileCallback(new LocalReader);
}

} // namespace osgLego
