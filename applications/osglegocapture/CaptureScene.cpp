#include "CaptureScene.h"

#include "ExitCode.h"
#include "InputFiles.h"
#include "ReadingGuard.h"
#include "SceneReach.h"

#include <common/BasePlate.h>
#include <common/LegolizeName.h>
#include <common/RacingCar.h>
#include <common/ReadableFile.h>
#include <common/UprightTurn.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <vector>

#include <fmt/format.h>
#include <osg/Math>
#include <osg/Timer>
#include <osg/Transform>
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/ReadFile>
#include <osgDB/Registry>

namespace osgLego
{

namespace
{

/** Finds the visible nodes of a class in a scene, without nodes below other nodes of that class. */
template <typename Found>
class Finder : public osg::NodeVisitor
{
public:
    explicit Finder(osg::Node& scene) : osg::NodeVisitor(TRAVERSE_ACTIVE_CHILDREN) { scene.accept(*this); }

    void apply(osg::Group& group) override
    {
        if (auto* found = dynamic_cast<Found*>(&group))
            _all.push_back(found);
        else
            traverse(group);
    }

    /** The first node; null if there is none. */
    Found* getFound() const { return _all.empty() ? nullptr : _all.front(); }
    std::vector<Found*> getAll() const { return _all; }

private:
    std::vector<Found*> _all;
};

/** The reason why a file found by OpenSceneGraph can't be read; empty if the file system gives none, or if it is not
 * found.
 */
std::string findObstacle(const std::string& fileName)
{
    const std::string path = osgDB::findDataFile(fileName);
    return path.empty() ? std::string() : findObstacleToReading(path);
}

/** That a file, or the one before the pseudo-loaders in its name, does not exist; empty if it is found. */
std::string findMissing(const std::string& fileName)
{
    const std::string model = LegolizeName::stripPseudoLoaders(fileName);
    if (model != fileName && model == "sample") return {}; // the built-in model is no file
    if (!osgDB::findDataFile(fileName).empty() || !osgDB::findDataFile(model).empty()) return {};
    return model == fileName ? "there is no such file" : "there is no file '" + model + "'";
}

/** The reason why OpenSceneGraph has not read a file. */
std::string explain(const std::string& fileName, const osgDB::ReaderWriter::ReadResult& result)
{
    if (std::string obstacle = findObstacle(fileName); !obstacle.empty()) return obstacle;
    const std::string missing = findMissing(fileName);
    // OSG reports a missing plugin with the status of other errors, so that only its message tells.
    if (result.message().find("Could not find plugin") != std::string::npos)
        return missing.empty()
                   ? "OpenSceneGraph has no reader for its ending; expected a mesh, such as .ply, .obj or .osgt"
                   : missing;
    const std::string ownPrefix = "osgLego: can't read '" + fileName + "': ";
    if (result.message().starts_with(ownPrefix)) return result.message().substr(ownPrefix.size());
    if (!result.message().empty()) return result.message();
    return missing.empty() ? "OpenSceneGraph can't read it; expected a complete file of the format of its ending"
                           : missing;
}

osg::ref_ptr<osg::Node> readMesh(const CaptureOptions& options)
{
    if (options.mesh.empty()) return createRacingCar();
    osg::ref_ptr<osgDB::Options> readerOptions = new osgDB::Options(options.readerOptions);
    osgDB::ReaderWriter::ReadResult result = osgDB::Registry::instance()->readNode(options.mesh, readerOptions);
    if (result.validNode()) return result.getNode();
    throw CaptureError(EXIT_BAD_INPUT, "'" + options.mesh + "': " + explain(options.mesh, result));
}

osg::Matrixd computeToWorld(const osg::Node& node)
{
    const osg::NodePathList paths = node.getParentalNodePaths();
    return paths.empty() ? osg::Matrixd() : osg::computeLocalToWorld(paths.front());
}

/** From a node's coordinates to those of the scene that it is in. */
osg::BoundingSphere transformed(const osg::BoundingSphere& sphere, const osg::Node& node)
{
    const osg::Matrixd toWorld = computeToWorld(node);
    const osg::Vec3d scale = toWorld.getScale();
    return {osg::Vec3d(sphere.center()) * toWorld,
            static_cast<float>(sphere.radius() * std::max({scale.x(), scale.y(), scale.z()}))};
}

double elapsed(osg::Timer_t start)
{
    return osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
}

} // namespace

CaptureScene::CaptureScene(const CaptureOptions& options) : _options(options)
{
    const ReadingGuard guard(options.mesh); // also of the walk over the scene, which may contain itself
    try
    {
        const osg::Timer_t start = osg::Timer::instance()->tick();
        _source = readMesh(options);
        _warning = InputFiles::describeMissing(options.mesh);
        _readingTime = elapsed(start);
        _isRead = true;
        prepare();
    }
    catch (const CaptureError&)
    {
        throw;
    }
    catch (const std::bad_alloc&)
    {
        throw CaptureError(EXIT_BAD_INPUT,
                           "'" + options.mesh +
                               "': there is not enough memory to read it; expected a smaller mesh, or a "
                               "file that is not damaged");
    }
    catch (const std::exception& error)
    {
        throw CaptureError(EXIT_BAD_INPUT, "'" + options.mesh + "': its reader has failed: " + error.what());
    }
}

CaptureScene::CaptureScene(const CaptureOptions& options, const osg::ref_ptr<osg::Node>& node) :
    _options(options), _source(node)
{
    prepare();
}

void CaptureScene::prepare()
{
    // A pseudo-loader may already have put a LegoNode above the mesh or a part of it.
    if (_options.original || _options.settings) unwrapSource();
    _shown = _source;
    if (_options.original) return;
    legolize();
    addOcclusion();
}

void CaptureScene::unwrapSource()
{
    osg::Node* inner = _source;
    if (auto* occlusion = dynamic_cast<AmbientOcclusionScene*>(inner); occlusion && occlusion->getNumChildren() == 1)
        inner = occlusion->getChild(0);
    if (isUprightTurn(*inner)) inner = inner->asGroup()->getChild(0);
    const osg::ref_ptr<LegoNode> lego = dynamic_cast<LegoNode*>(inner);
    if (!lego) return;
    if (lego->getStoredBricks() && lego->getNumChildren() == 0)
        throw CaptureError(EXIT_BAD_INPUT,
                           "'" + _options.mesh + "' has stored bricks but no mesh; expected " +
                               (!_options.build.empty() ? "--instructions, which writes a booklet for these bricks"
                                : _options.original     ? "it without --original"
                                                        : "it without --legolize"));
    osg::ref_ptr<osg::Group> group = new osg::Group;
    for (unsigned int child = 0; child < lego->getNumChildren(); ++child)
        group->addChild(lego->getChild(child));
    _source = group;
    _sourceSettings = lego->getSettings();
}

void CaptureScene::legolize()
{
    if (!_options.settings) _lego = Finder<LegoNode>(*_source).getFound();
    _hasOwnBricks = _isRead && _lego;
    if (!_lego)
    {
        const LegoSettings settings = _options.settings.value_or(LegoSettings());
        std::string error;
        if (!Palette::read(settings, error) && !error.empty()) throw CaptureError(EXIT_BAD_INPUT, error);
        _lego = new LegoNode(settings);
        _lego->setName(_options.mesh);
        _lego->addChild(_source);
        _shown = _lego;
    }
    _lego->setWaiting(true);
    // Set before the source is examined, which would otherwise be repeated.
    _lego->setTiming(!_options.statistics.empty());
    _lego->setReadBack(!_options.statistics.empty() || !_options.cells.empty());
    if (!_lego->hasTriangles())
        throw CaptureError(EXIT_BAD_INPUT, "'" + _options.mesh + "' has no triangles to legolize; expected a mesh");
    if (const std::string obstacle = _lego->getObstacle(); !obstacle.empty())
        throw CaptureError(EXIT_BAD_INPUT, obstacle);
}

void CaptureScene::addOcclusion()
{
    // Bricks that a file already had keep its light and its occlusion, unless the command line has its own.
    if (!_hasOwnBricks || _options.probe != CaptureProbe()) setProbe(*createProbe());
    if (!_hasOwnBricks || _options.isOcclusionGiven) setOcclusion();
    _occlusion = Finder<AmbientOcclusionScene>(*_shown).getFound();
    for (AmbientOcclusionScene* occlusion : Finder<AmbientOcclusionScene>(*_shown).getAll())
        occlusion->setTiming(!_options.statistics.empty());
}

void CaptureScene::setOcclusion()
{
    for (LegoNode* lego : Finder<LegoNode>(*_shown).getAll())
    {
        BrickAppearance appearance = lego->getAppearance();
        appearance.occlusion = _options.brickOcclusion;
        appearance.distantOcclusion = _options.occlusion.distant;
        lego->setAppearance(appearance);
    }
    const bool hasGroup = Finder<AmbientOcclusionScene>(*_shown).getFound() != nullptr;
    if (_lego->getSettings().view.look == Look::FULL && _options.hasOcclusion && !hasGroup)
    {
        osg::ref_ptr<AmbientOcclusionScene> occlusion = new AmbientOcclusionScene;
        occlusion->setLightProbe(_lego->getLightProbe().get());
        occlusion->addChild(_shown);
        _shown = occlusion;
    }
    for (AmbientOcclusionScene* occlusion : Finder<AmbientOcclusionScene>(*_shown).getAll())
    {
        occlusion->setEnabled(_options.hasOcclusion);
        occlusion->setSettings(_options.occlusion);
    }
}

void CaptureScene::setProbe(const LightProbe& probe)
{
    for (LegoNode* lego : Finder<LegoNode>(*_shown).getAll())
        lego->setLightProbe(&probe);
    for (AmbientOcclusionScene* occlusion : Finder<AmbientOcclusionScene>(*_shown).getAll())
        occlusion->setLightProbe(&probe);
}

osg::ref_ptr<LightProbe> CaptureScene::createProbe() const
{
    osg::ref_ptr<LightProbe> probe = new LightProbe;
    if (!_options.probe.file.empty())
    {
        const std::string obstacle = findObstacle(_options.probe.file);
        if (!obstacle.empty())
            throw CaptureError(EXIT_BAD_INPUT, "can't read '" + _options.probe.file + "': " + obstacle);
        std::string error;
        probe = LightProbe::read(_options.probe.file, error);
        if (!probe) throw CaptureError(EXIT_BAD_INPUT, error);
    }
    const osg::Quat turn(osg::DegreesToRadians(_options.probe.turn), osg::Vec3d(0, 0, 1));
    const osg::Quat upright = getUpAxis() == UpAxis::Y ? osg::Quat(-0.5 * osg::PI, osg::Vec3d(1, 0, 0)) : osg::Quat();
    probe->setRotation(turn * upright);
    probe->setIntensity(_options.probe.intensity);
    return probe;
}

LegoNode& CaptureScene::getOnlyLegoNode() const
{
    if (const std::size_t number = findLegoNodes().size(); number != 1)
        throw CaptureError(EXIT_BAD_INPUT, fmt::format("'{}' has {} models in bricks; expected one for --instructions",
                                                       _options.mesh, number));
    return *_lego;
}

void CaptureScene::checkHasParts(const char* purpose) const
{
    const std::vector<LegoNode*> all = findLegoNodes();
    const auto hasParts = [](const LegoNode* lego)
    {
        const osg::ref_ptr<const BrickModel> stored = lego->getStoredBricks();
        return stored ? !stored->getParts().empty() : lego->getSettings().parts.set != PartSet::NONE;
    };
    if (std::none_of(all.begin(), all.end(), hasParts)) throwWithoutParts(purpose);
}

std::vector<LegoNode*> CaptureScene::findLegoNodes() const
{
    return Finder<LegoNode>(*_shown).getAll();
}

PartsList CaptureScene::createPartsList() const
{
    PartsList list;
    for (const LegoNode* lego : findLegoNodes())
    {
        std::string error;
        const osg::ref_ptr<const BrickModel> model = lego->getBricks();
        const osg::ref_ptr<const Palette> palette = Palette::read(lego->getSettings(), error);
        // Stored bricks don't need the file of their palette: LDraw's codes name their colours.
        if (!error.empty() && !lego->getStoredBricks()) throw CaptureError(EXIT_BAD_INPUT, error);
        const std::span<const PaletteColor> colors = palette         ? palette->getColors()
                                                     : error.empty() ? std::span<const PaletteColor>()
                                                                     : Palette::getKnownColors();
        if (!model) continue;
        list.add(*model, colors);
        if (_options.base == BuildingBase::PLATE && !model->getParts().empty())
            list.addExtra(BasePlate(*model).createRow());
    }
    if (list.getRows().empty()) throwWithoutParts(TO_LIST);
    return list;
}

std::vector<osg::ref_ptr<const BrickModel>> CaptureScene::findPartModels() const
{
    std::vector<osg::ref_ptr<const BrickModel>> models;
    for (const LegoNode* lego : findLegoNodes())
        if (const osg::ref_ptr<const BrickModel> model = lego->getBricks(); model && !model->getParts().empty())
            models.push_back(model);
    if (models.empty()) throwWithoutParts(TO_STAND);
    return models;
}

void CaptureScene::throwWithoutParts(const char* purpose) const
{
    const std::string name = _options.mesh.empty() ? "the built-in model" : "'" + _options.mesh + "'";
    throw CaptureError(EXIT_BAD_INPUT,
                       name + " has no parts " + purpose + "; expected parts=bricks among its settings");
}

void CaptureScene::addBasePlate(const BrickModel& plate)
{
    LegoSettings settings;
    settings.view.look = _lego->getSettings().view.look;
    _basePlate = new LegoNode(settings);
    _basePlate->setWaiting(true);
    _basePlate->setStoredBricks(&plate);
    _basePlate->setAppearance(_lego->getAppearance());
    _basePlate->setLightProbe(_lego->getLightProbe().get());
    const std::vector<osg::Group*> parents = _lego->getParents();
    for (osg::Group* parent : parents) // with its turns
        parent->addChild(_basePlate);
    if (!parents.empty()) return;
    const osg::ref_ptr<osg::Group> both = new osg::Group;
    both->addChild(_shown);
    both->addChild(_basePlate);
    _shown = both;
}

bool CaptureScene::isInSource() const
{
    return _lego && Finder<LegoNode>(*_source).getFound() == _lego;
}

osg::BoundingSphere CaptureScene::getBound() const
{
    const bool hasMesh = isInSource() && !_lego->getStoredBricks();
    osg::BoundingSphere bound = hasMesh ? transformed(_lego->osg::Group::computeBound(), *_lego) : _source->getBound();
    if (!_lego) return bound;
    const osg::BoundingSphere bricks = transformed(_lego->getBound(), *_lego);
    // Triangles that reach to infinity have no bricks; a warning has said so.
    if (!std::isfinite(bound.radius()) || !std::isfinite(bound.center().length())) return bricks;
    // A grid beside the mesh has no bricks, but is drawn.
    if (!bound.intersects(bricks)) bound.expandBy(bricks);
    return bound;
}

void CaptureScene::addTo(SceneReach& reach) const
{
    if (isInSource())
        _source->accept(reach);
    else
        reach.addSource(*_source, getSettings());
    if (_basePlate && !isInSource()) _basePlate->accept(reach);
}

UpAxis CaptureScene::getUpAxis() const
{
    const UpAxis axis = getSettings().grid.upAxis;
    // The pseudo-loader turns bricks with Y upwards, so that their studs point along Z in the scene.
    const bool isTurned =
        _lego && axis == UpAxis::Y && osg::Matrixd::transform3x3(osg::Vec3d(0, 1, 0), computeToWorld(*_lego)).z() > 0.5;
    return isTurned ? UpAxis::Z : axis;
}

LegoSettings CaptureScene::getSettings() const
{
    // The settings of the node may have been chosen since.
    return _lego ? _lego->getSettings() : _options.settings.value_or(_sourceSettings);
}

} // namespace osgLego
