#include "LegolizeOptions.h"
#include "LegolizeSettings.h"

#include <common/LegolizeName.h>
#include <common/RacingCar.h>
#include <common/ReadableFile.h>
#include <common/UprightTurn.h>
#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/LegoNode.h>
#include <osgLego/Palette.h>

#include <vector>

#include <osg/NodeVisitor>
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/ReaderWriter>
#include <osgDB/Registry>

/** Finds the nodes whose bricks are stored. */
class StoredBricksFinder : public osg::NodeVisitor
{
public:
    StoredBricksFinder() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}

    void apply(osg::Group& group) override
    {
        auto* lego = dynamic_cast<osgLego::LegoNode*>(&group);
        if (lego && lego->getStoredBricks()) found.push_back(lego);
        traverse(group);
    }

    std::vector<osgLego::LegoNode*> found;
};

/** The pseudo-loader `.legolize`: reads the file named before the extension and puts it under an osgLego::LegoNode.
 * With `up=y`, this is put under a transform that turns the bricks upright, and with `occlusion=screen` or `both`,
 * under an osgLego::AmbientOcclusionScene.
 *
 *     osgviewer bunny.ply.legolize
 *     osgviewer "bunny.ply.(64,proportions=plate,up=y).legolize"
 *     osgviewer bunny.ply.legolize -O "64,proportions=plate"
 *     osgviewer sample.legolize
 *
 * See LegolizeSettings for the settings; those in the name override those in the options. Options that are not settings
 * are passed to the reader of the file. */
class ReaderWriterLegolize : public osgDB::ReaderWriter
{
public:
    ReaderWriterLegolize()
    {
        supportsExtension("legolize", "Pseudo-loader that turns a model into bricks");
        const osgLego::SettingDescription& first = LegolizeSettings::describe().front();
        supportsOption(first.form, first.key + ": " + first.meaning + ", " + first.values);
        for (const osgLego::SettingDescription& setting : LegolizeSettings::describe())
            supportsOption(setting.key + "=" + setting.form,
                           setting.meaning + ": " + setting.values + " (" + setting.defaultValue + ")");
    }

    const char* className() const override { return "legolize pseudo-loader"; }

    ReadResult readObject(const std::string& name, const Options* options) const override
    {
        return readNode(name, options);
    }

    ReadResult readNode(const std::string& name, const Options* options) const override
    {
        osgLego::LegolizeName parsed;
        if (!osgLego::LegolizeName::parse(name, parsed)) return ReadResult::FILE_NOT_HANDLED;

        const LegolizeOptions own = LegolizeOptions::parse(options ? options->getOptionString() : std::string());
        LegolizeSettings settings;
        std::string error;
        for (const std::string& text : {own.settings, parsed.settings})
            if (!text.empty() && !LegolizeSettings::parse(text, settings, error)) return ReadResult(error);
        if (!osgLego::Palette::read(settings.lego, error) && !error.empty()) return ReadResult(error);
        const osg::ref_ptr<osgLego::LightProbe> probe = readProbe(settings, options, error);
        if (!probe) return ReadResult(error);

        if (parsed.fileName == "sample") return legolize(osgLego::createRacingCar(), settings, *probe, name);
        osg::ref_ptr<Options> rest = options ? options->cloneOptions() : new Options;
        rest->setOptionString(own.rest);
        ReadResult result = osgDB::Registry::instance()->readNode(parsed.fileName, rest);
        if (!result.validNode())
        {
            const std::string obstacle = findObstacle(parsed.fileName, name, rest);
            if (!obstacle.empty()) return ReadResult(obstacle);
        }
        // Don't return "not handled": this is the reader of .legolize, and osgDB need not search for another one.
        if (result.notHandled()) return ReadResult("there is no reader for '" + parsed.fileName + "'");
        if (!result.validNode()) return result;
        StoredBricksFinder finder;
        result.getNode()->accept(finder);
        if (!finder.found.empty()) return showStored(result.getNode(), finder.found, parsed.fileName, settings, *probe);
        return legolize(result.getNode(), settings, *probe, name);
    }

private:
    /** The reason why a file can't be read, if it is in the name or the file system; otherwise empty. */
    static std::string findObstacle(const std::string& fileName, const std::string& name, const Options* options)
    {
        const std::string path = osgDB::findDataFile(fileName, options);
        if (path.empty()) return osgLego::LegolizeName::findLoneBracket(name);
        const std::string obstacle = osgLego::findObstacleToReading(path);
        return obstacle.empty() ? obstacle : "can't read '" + fileName + "': " + obstacle;
    }

    /** Read the environment light. @return null, with the reason in `error`, if its picture can't
     * be used. */
    static osg::ref_ptr<osgLego::LightProbe> readProbe(const LegolizeSettings& settings, const Options* options,
                                                       std::string& error)
    {
        osg::ref_ptr<osgLego::LightProbe> probe = new osgLego::LightProbe;
        if (settings.probe)
        {
            const std::string found = osgDB::findDataFile(*settings.probe, options);
            probe = osgLego::LightProbe::read(found.empty() ? *settings.probe : found, error);
        }
        return probe;
    }

    /** The keys that also apply to bricks that a file has already. */
    static std::string listViewKeys()
    {
        std::string list;
        for (const osgLego::SettingDescription& setting : LegolizeSettings::describe())
            if (setting.group == "view" || setting.group.empty()) list += (list.empty() ? "" : ", ") + setting.key;
        return list;
    }

    static void setLight(osgLego::LegoNode& lego, const LegolizeSettings& settings, const osgLego::LightProbe& probe)
    {
        lego.setLightProbe(&probe);
        osgLego::BrickAppearance appearance = lego.getAppearance();
        appearance.occlusion = settings.getOcclusion();
        appearance.distantOcclusion = settings.distant;
        lego.setAppearance(appearance);
    }

    /** Show a file that already consists of bricks, by the settings. */
    static ReadResult showStored(const osg::ref_ptr<osg::Node>& source, const std::vector<osgLego::LegoNode*>& nodes,
                                 const std::string& fileName, const LegolizeSettings& settings,
                                 const osgLego::LightProbe& probe)
    {
        if (!settings.lego.givesSameBricks(osgLego::LegoSettings()))
            return ReadResult("'" + fileName + "' is in bricks already; expected no settings other than " +
                              listViewKeys());
        for (osgLego::LegoNode* lego : nodes)
        {
            osgLego::LegoSettings shown = lego->getSettings();
            shown.view = settings.lego.view;
            lego->setSettings(shown);
            setLight(*lego, settings, probe);
        }
        return addOcclusion(source, settings, probe, source->getName());
    }

    static ReadResult legolize(const osg::ref_ptr<osg::Node>& source, const LegolizeSettings& settings,
                               const osgLego::LightProbe& probe, const std::string& name)
    {
        osg::ref_ptr<osgLego::LegoNode> lego = new osgLego::LegoNode(settings.lego);
        lego->setName(name);
        lego->addChild(source);
        if (!lego->hasTriangles()) return ReadResult("there are no triangles to legolize in it; expected a mesh");
        if (const std::string obstacle = lego->getObstacle(); !obstacle.empty()) return ReadResult(obstacle);
        setLight(*lego, settings, probe);
        if (settings.lego.grid.upAxis == osgLego::UpAxis::Y)
            return addOcclusion(osgLego::turnUpright(*lego), settings, probe, name);
        return addOcclusion(lego, settings, probe, name);
    }

    static ReadResult addOcclusion(const osg::ref_ptr<osg::Node>& bricks, const LegolizeSettings& settings,
                                   const osgLego::LightProbe& probe, const std::string& name)
    {
        const std::optional<osgLego::AmbientOcclusionSettings> occlusion = settings.getScene();
        if (!occlusion) return bricks.get();
        osg::ref_ptr<osgLego::AmbientOcclusionScene> scene = new osgLego::AmbientOcclusionScene;
        scene->setSettings(*occlusion);
        scene->setLightProbe(&probe);
        scene->setName(name);
        scene->addChild(bricks);
        return scene.get();
    }
};

REGISTER_OSGPLUGIN(legolize, ReaderWriterLegolize)
