#include "DepthPictureContender.h"

#include <osgLego/gl/ShaderLibrary.h>

namespace osgLego
{

namespace
{

constexpr int PREVIOUS_DEPTH_UNIT = 1; // unit 0 is the surface's texture

} // namespace

std::string DepthPictureContender::createObjects(osg::State& state)
{
    const bool isPeeling = _method == Method::PASSALIS;
    _program = ShaderLibrary::getProgram(isPeeling ? "depth peeling" : "depth picture",
                                         {"depth_picture.vert", "depth_picture.frag"},
                                         isPeeling ? "#define IS_PEELING\n" : "");
    if (std::string error = linkProgram(*_program, state); !error.empty()) return error;
    for (int axis = 0; axis < 3; ++axis)
    {
        DepthPicture& picture = _pictures[static_cast<std::size_t>(axis)];
        if (std::string error = picture.create(state, getGrid().dimensions, axis, isPeeling ? 2 : 1); !error.empty())
            return error;
    }
    _query = GlQuery(state);
    return ReadBackContender::createObjects(state);
}

void DepthPictureContender::gatherCells(osg::State& state, GatheredCells& cells)
{
    _program->apply(state);
    glEnable(GL_DEPTH_TEST);
    for (DepthPicture& picture : _pictures)
    {
        picture.setUniforms(ProgramUniforms(state));
        if (_method == Method::KARABASSI)
            drawBothEnds(state, picture, cells);
        else
            peel(state, picture, cells);
    }
}

void DepthPictureContender::drawBothEnds(osg::State& state, DepthPicture& picture, GatheredCells& cells) const
{
    // The view from the opposite direction is the same picture, but with the farthest surface in front.
    for (const bool isFromFarEnd : {false, true})
    {
        glDepthFunc(isFromFarEnd ? GL_GEQUAL : GL_LEQUAL);
        picture.begin(state, 0, isFromFarEnd ? 0.0 : 1.0);
        draw(state);
        picture.readCells(cells);
    }
}

void DepthPictureContender::peel(osg::State& state, DepthPicture& picture, GatheredCells& cells) const
{
    ProgramUniforms(state).set("previousDepth", PREVIOUS_DEPTH_UNIT);
    glDepthFunc(GL_LESS);
    // No pixel has more layers than there are triangles. This limit ends the loop even if GL rounds the stored depth
    // differently from the depth that it passes to the shader.
    const std::size_t mostLayers = getTriangles().getNumTriangles();
    for (std::size_t layer = 0; layer < mostLayers && drawLayer(state, picture, layer); ++layer)
        picture.readCells(cells);
    state.setActiveTextureUnit(PREVIOUS_DEPTH_UNIT);
    glBindTexture(GL_TEXTURE_2D, 0);
}

bool DepthPictureContender::drawLayer(osg::State& state, const DepthPicture& picture, std::size_t layer) const
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    state.setActiveTextureUnit(PREVIOUS_DEPTH_UNIT);
    glBindTexture(GL_TEXTURE_2D, picture.getDepthTexture((layer + 1) % 2));
    ProgramUniforms(state).set("isFirstLayer", layer == 0 ? 1 : 0);
    picture.begin(state, layer % 2, 1.0);
    extensions.glBeginQuery(GL_SAMPLES_PASSED, _query.get());
    draw(state);
    extensions.glEndQuery(GL_SAMPLES_PASSED);
    GLuint numSamples = 0;
    extensions.glGetQueryObjectuiv(_query.get(), GL_QUERY_RESULT, &numSamples);
    return numSamples > 0;
}

void DepthPictureContender::releaseObjects()
{
    _pictures = {};
    _program = nullptr;
    _query = GlQuery();
    ReadBackContender::releaseObjects();
}

} // namespace osgLego
