#include "KarabassiContender.h"

#include <osgLego/gl/ShaderLibrary.h>

namespace osgLego
{

std::string KarabassiContender::createObjects(osg::State& state)
{
    _program = ShaderLibrary::createProgram("depth picture", {"depth_picture.vert", "depth_picture.frag"});
    if (std::string error = linkProgram(*_program, state); !error.empty()) return error;
    if (std::string error = createDepthPictures(state, getGrid().dimensions, 1, _pictures); !error.empty())
        return error;
    return ReadBackContender::createObjects(state);
}

void KarabassiContender::gatherCells(osg::State& state, GatheredCells& cells)
{
    _program->apply(state);
    const ProgramUniforms uniforms(state);
    glEnable(GL_DEPTH_TEST);
    for (DepthPicture& picture : _pictures)
    {
        picture.setUniforms(uniforms);
        // The view from the other end is the same picture with the farthest surface in front.
        for (const bool isFromFarEnd : {false, true})
        {
            glDepthFunc(isFromFarEnd ? GL_GEQUAL : GL_LEQUAL);
            picture.begin(state, 0, isFromFarEnd ? 0.0 : 1.0);
            getDrawing().draw(state);
            picture.readCells(cells);
        }
    }
}

void KarabassiContender::releaseObjects()
{
    _pictures = {};
    _program = nullptr;
    ReadBackContender::releaseObjects();
}

} // namespace osgLego
