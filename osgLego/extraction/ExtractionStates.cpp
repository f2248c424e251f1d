#include <osgLego/extraction/ExtractionStates.h>

#include <osgLego/gl/PassState.h>
#include <osgLego/gl/ShaderLibrary.h>
#include <osgLego/gl/StateOverride.h>

namespace osgLego
{

namespace
{

osg::ref_ptr<osg::StateSet> createState(const char* name, std::initializer_list<const char*> shaders,
                                        const char* captured, osg::Texture2D& voxelImage,
                                        const std::string& definitions = {})
{
    const osg::ref_ptr<osg::Program> program = ShaderLibrary::getProgram(name, shaders, definitions, {captured});
    osg::ref_ptr<osg::StateSet> stateSet = createPassState(*program);
    stateSet->setTextureAttribute(0, &voxelImage, OVERRIDE_PROTECTED);
    return stateSet;
}

std::string definitionsOf(const PassPlan& plan)
{
    std::string definitions;
    if (plan.getExtractedFormat() != VoxelFormat::COLOR) definitions += "#define WEIGHTED_COLORS\n";
    if (plan.hasPalette) definitions += "#define PALETTE\n";
    return definitions;
}

} // namespace

ExtractionStates::ExtractionStates(osg::Texture2D& voxelImage, const PassPlan& plan) :
    _occupancy(createState("extraction occupancy", {"extraction/extraction_occupancy.vert"}, "word", voxelImage)),
    _words(createState("extraction words", {"extraction/extraction_words.vert", "extraction/extraction_words.geom"},
                       "word", voxelImage)),
    _bricks(createState("extraction", {"extraction/extraction.vert", "extraction/extraction.geom"}, "brick", voxelImage,
                        definitionsOf(plan))),
    _neighbors(createState("extraction neighbours", {"extraction/extraction_neighbors.vert"}, "neighbors", voxelImage))
{
}

void ExtractionStates::releaseGLObjects(osg::State* state) const
{
    for (const osg::ref_ptr<osg::StateSet>& stateSet : {_occupancy, _words, _bricks, _neighbors})
        stateSet->releaseGLObjects(state);
}

void ExtractionStates::resizeGLObjectBuffers(unsigned int maxSize) const
{
    for (const osg::ref_ptr<osg::StateSet>& stateSet : {_occupancy, _words, _bricks, _neighbors})
        stateSet->resizeGLObjectBuffers(maxSize);
}

} // namespace osgLego
