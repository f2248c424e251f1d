#include "PassalisContender.h"

#include <osgLego/gl/ShaderLibrary.h>

namespace osgLego
{

namespace
{

constexpr int PREVIOUS_DEPTH_UNIT = 1; // unit 0 is the surface's texture

} // namespace

std::string PassalisContender::createObjects(osg::State& state)
{
    _program = ShaderLibrary::createProgram("depth peeling", {"depth_picture.vert", "depth_picture.frag"},
                                            "#define IS_PEELING\n");
    if (std::string error = linkProgram(*_program, state); !error.empty()) return error;
    if (std::string error = createDepthPictures(state, getGrid().dimensions, 2, _pictures); !error.empty())
        return error;
    _query = GlQuery(state);
    return ReadBackContender::createObjects(state);
}

void PassalisContender::gatherCells(osg::State& state, GatheredCells& cells)
{
    _program->apply(state);
    ProgramUniforms(state).set("previousDepth", PREVIOUS_DEPTH_UNIT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    for (DepthPicture& picture : _pictures)
        peel(state, picture, cells);
}

void PassalisContender::peel(osg::State& state, DepthPicture& picture, GatheredCells& cells) const
{
    picture.setUniforms(ProgramUniforms(state));
    // No pixel has more layers than there are triangles: an end even where GL should round the depth that it keeps
    // otherwise than the one that it hands to the shader.
    const std::size_t mostLayers = getTriangles().getNumTriangles();
    for (std::size_t layer = 0; layer < mostLayers && drawLayer(state, picture, layer); ++layer)
        picture.readCells(cells);
    state.setActiveTextureUnit(PREVIOUS_DEPTH_UNIT);
    glBindTexture(GL_TEXTURE_2D, 0);
}

bool PassalisContender::drawLayer(osg::State& state, const DepthPicture& picture, std::size_t layer) const
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    state.setActiveTextureUnit(PREVIOUS_DEPTH_UNIT);
    glBindTexture(GL_TEXTURE_2D, picture.getDepthTexture((layer + 1) % 2));
    ProgramUniforms(state).set("isFirstLayer", layer == 0 ? 1 : 0);
    picture.begin(state, layer % 2, 1.0);
    extensions.glBeginQuery(GL_SAMPLES_PASSED, _query.get());
    getDrawing().draw(state);
    extensions.glEndQuery(GL_SAMPLES_PASSED);
    GLuint numSamples = 0;
    extensions.glGetQueryObjectuiv(_query.get(), GL_QUERY_RESULT, &numSamples);
    return numSamples > 0;
}

void PassalisContender::releaseObjects()
{
    _pictures = {};
    _program = nullptr;
    _query = GlQuery();
    ReadBackContender::releaseObjects();
}

} // namespace osgLego
