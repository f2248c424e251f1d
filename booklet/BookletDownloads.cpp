#include "BookletDownloads.h"

#include "BookletFailure.h"

#include <sstream>

#include <osg/Version>
#include <osgDB/Options>
#include <osgDB/Registry>

namespace osgLego
{

namespace
{

/** The model in LDraw's format, with its steps and submodels. */
std::string createMpd(const LegoNode& lego, const std::string& fileName, const ModelHeader& header, bool isOnPlate)
{
    osg::ref_ptr<osgDB::Options> options = new osgDB::Options;
    options->setPluginStringData("STREAM_FILENAME", fileName); // as OSG's own plugins name streams
    options->setPluginStringData("TITLE", header.title);
    options->setPluginStringData("AUTHOR", header.author);
    options->setPluginStringData("LICENSE", header.license);
    if (isOnPlate) options->setPluginStringData("BASE", "plate");
    std::ostringstream stream;
    const osgDB::ReaderWriter::WriteResult result = findLDrawWriter().writeNode(lego, stream, options);
    if (!result.success()) throw BookletFailure(BookletError::Reason::BAD_MODEL, result.message());
    return stream.str();
}

} // namespace

osgDB::ReaderWriter& findLDrawWriter()
{
    osgDB::ReaderWriter* writer = osgDB::Registry::instance()->getReaderWriterForExtension("mpd");
    if (!writer)
        throw BookletFailure(BookletError::Reason::NO_PLUGIN,
                             "there is no plugin osgdb_ldraw to write .mpd; expected it in a folder osgPlugins-" +
                                 std::string(osgGetVersion()) + " below one of those in OSG_LIBRARY_PATH");
    return *writer;
}

std::vector<BookletDownload> createDownloads(const std::string& name, const BookletModel& model, const LegoNode& lego,
                                             const ModelHeader& header)
{
    std::ostringstream wanted;
    model.getPartsList().writeWantedList(wanted);
    std::ostringstream table;
    model.getPartsList().writeCsv(table);
    return {{"Wanted list (BrickLink)", name + ".xml", "application/xml", wanted.str()},
            {"Parts list (CSV)", name + ".csv", "text/csv", table.str()},
            {"Model (LDraw)", name + ".mpd", "application/x-multi-part-ldraw",
             createMpd(lego, name + ".mpd", header, model.getBasePlate().has_value())}};
}

} // namespace osgLego
