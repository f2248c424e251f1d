#include <osgLego/voxelization/ExactCells.h>

#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/gl/ShaderLibrary.h>
#include <osgLego/passes/GridVertexArrays.h>

#include <string>

namespace osgLego
{

namespace
{

constexpr int LOOKUP_UNIT = 1; // unit 0 is the surface's texture

} // namespace

osg::ref_ptr<osg::Program> getExactCellsProgram(const char* name, const char* fragmentShader, int cellsPerTriangle)
{
    return ShaderLibrary::getProgram(
        name, {"voxelization/voxelization_exact.vert", "voxelization/voxelization_exact.geom", fragmentShader},
        "#define MAXIMUM_CELLS " + std::to_string(cellsPerTriangle) + "\n");
}

void drawExactCells(osg::State& state, const Legolization& work,
                    const std::function<void(const GridBatch&)>& bindSurface)
{
    ProgramUniforms(state).set("sourceVertices", LOOKUP_UNIT);
    const GridVertexArrays arrays(*state.get<osg::GLExtensions>(), false);
    for (const WorkingBatch& batch : work.batches)
    {
        bindSurface(*batch.batch);
        state.setActiveTextureUnit(LOOKUP_UNIT);
        glBindTexture(GL_TEXTURE_BUFFER, batch.lookup.get());
        batch.bindFine(arrays);
        glDrawArrays(GL_TRIANGLES, 0, 3 * batch.numFineTriangles);
        glBindTexture(GL_TEXTURE_BUFFER, 0);
    }
}

} // namespace osgLego
