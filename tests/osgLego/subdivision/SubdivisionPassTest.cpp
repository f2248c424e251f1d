#include <osgLego/gl/GlObject.h>
#include <osgLego/producer/GpuProducer.h>
#include <osgLego/subdivision/SubdivisionPass.h>

#include <FineTriangles.h>
#include <GlTest.h>

#include <osg/Geometry>
#include <osg/RenderInfo>

namespace osgLego::test
{

namespace
{

osg::ref_ptr<osg::Geometry> toGeometry(const GridVertices& triangles)
{
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array;
    for (const GridVertex& vertex : triangles)
    {
        vertices->push_back(osg::Vec3(vertex.position.x, vertex.position.y, vertex.position.z));
        const glm::vec3 color = vertex.getColor();
        colors->push_back(osg::Vec4(color.r, color.g, color.b, 1.0f));
    }
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(vertices);
    geometry->setColorArray(colors, osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices->size())));
    return geometry;
}

/** Runs the pass alone, and reads its fine triangles back. */
class SubdivisionPassTest : public GlTest
{
protected:
    void subdivide(const GridVertices& triangles, double edgeLimit)
    {
        const osg::ref_ptr<osg::GraphicsContext> context = createContext();
        context->makeCurrent();
        osg::State& state = *context->getState();

        osg::ref_ptr<LegoSource> source = new LegoSource;
        source->revision = 1;
        source->settings = parseSettings("cell=1,method=points,target=addressed"); // fine triangles with colours
        source->settings.voxelization.edgeLimit = edgeLimit;
        source->triangles = GridTriangles::create(*SceneTriangles::create(*toGeometry(triangles)), source->settings);
        ASSERT_EQ(source->triangles->getBatches().size(), 1u);
        _source = source->triangles->getBatches().front().vertices;
        ASSERT_EQ(_source.size(), triangles.size());

        const osg::ref_ptr<BrickStore> store = new BrickStore;
        const osg::ref_ptr<PassWorkspace> workspace = new PassWorkspace(*store);
        workspace->setSource(*source, *createGpuBrickSet(*source));
        const osg::ref_ptr<SubdivisionPass> pass = new SubdivisionPass(*workspace, PassPlan::create(*source));
        state.apply(pass->getStateSet());
        osg::RenderInfo renderInfo(&state, nullptr);
        pass->drawImplementation(renderInfo);
        readBack(state, *workspace->getContext(state.getContextID()));
        workspace->releaseGLObjects(nullptr);
        pass->releaseGLObjects(&state);
    }

    GridVertices _source;
    FineTriangles _fine;

private:
    void readBack(const osg::State& state, const PassContext& passContext)
    {
        ASSERT_TRUE(passContext.work);
        const Legolization& work = *passContext.work;
        ASSERT_EQ(work.batches.size(), 1u);
        const WorkingBatch& batch = work.batches.front();
        _fine.numPasses = work.statistics.numSubdivisionPasses;
        _fine.vertices.resize(3 * static_cast<std::size_t>(batch.numFineTriangles));
        const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
        extensions.glBindBuffer(GL_ARRAY_BUFFER, batch.fine.get());
        extensions.glGetBufferSubData(GL_ARRAY_BUFFER, 0,
                                      static_cast<GLsizeiptr>(_fine.vertices.size() * sizeof(GridVertex)),
                                      _fine.vertices.data());
        extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
    }
};

TEST_F(SubdivisionPassTest, PreservesAreasAndNormals)
{
    for (const double limit : {0.5, 1.0, 2.0})
    {
        subdivide(createTetrahedra(5, 60, false), limit);
        expectSameAreas(_source, _fine.vertices);
        expectSameNormals(_source, _fine.vertices);
    }
}

TEST_F(SubdivisionPassTest, LeavesNoCracksBetweenNeighbours)
{
    for (const double limit : {0.5, 1.0, 2.0})
    {
        subdivide(createTetrahedra(6, 60, false), limit);
        expectNoCracks(_source);
        expectNoCracks(_fine.vertices);
    }
}

TEST_F(SubdivisionPassTest, LeavesNoLongEdgeAfterTheExpectedNumberOfPasses)
{
    for (const double limit : {0.5, 1.0, 2.0})
    {
        subdivide(createTetrahedra(7, 60, false), limit);
        expectShortEdges(_fine.vertices, limit);
        EXPECT_GE(_fine.numPasses, 4u);
        EXPECT_LE(_fine.numPasses, mostPasses(_source, limit));
    }
}

TEST_F(SubdivisionPassTest, CutsTrianglesAsTheCpuDoes)
{
    // The geometry has no texture coordinates; colours may be rounded differently in each pass.
    subdivide(createTetrahedra(8, 100, false), 1.0);
    const FineTriangles expected = subdivideOnCpu(_source, 1.0);
    ASSERT_EQ(_fine.vertices.size(), expected.vertices.size());
    EXPECT_EQ(_fine.numPasses, expected.numPasses);
    for (std::size_t vertex = 0; vertex < expected.vertices.size(); ++vertex)
    {
        ASSERT_EQ(_fine.vertices[vertex].position, expected.vertices[vertex].position) << vertex;
        ASSERT_EQ(_fine.vertices[vertex].triangle, expected.vertices[vertex].triangle) << vertex;
        ASSERT_LT(glm::distance(_fine.vertices[vertex].getColor(), expected.vertices[vertex].getColor()), 5e-4f);
    }
}

} // namespace

} // namespace osgLego::test
