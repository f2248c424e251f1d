#include <osgLego/flattening/SceneTriangleCollector.h>

#include <osgLego/flattening/ArrayElements.h>
#include <osgLego/flattening/ColorFraction.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <osg/TriangleFunctor>
#include <osg/TriangleIndexFunctor>

namespace osgLego
{

namespace
{

struct IndexTriangles
{
    std::size_t numVertices = 0;
    std::vector<std::array<unsigned int, 3>> indices;

    void operator()(unsigned int a, unsigned int b, unsigned int c)
    {
        if (std::max({a, b, c}) < numVertices) indices.push_back({a, b, c});
    }
};

/** Collects the indices of complete triangles: OSG's functor reads past the end of GL_TRIANGLES whose last triangle is
 * incomplete. */
class WholeTriangles : public osg::TriangleIndexFunctor<IndexTriangles>
{
public:
    explicit WholeTriangles(std::size_t vertices) { numVertices = vertices; }

    void drawElements(GLenum mode, GLsizei count, const GLubyte* first) override { drawWhole(mode, count, first); }
    void drawElements(GLenum mode, GLsizei count, const GLushort* first) override { drawWhole(mode, count, first); }
    void drawElements(GLenum mode, GLsizei count, const GLuint* first) override { drawWhole(mode, count, first); }

private:
    template <typename Index>
    void drawWhole(GLenum mode, GLsizei count, const Index* first)
    {
        osg::TriangleIndexFunctor<IndexTriangles>::drawElements(mode, mode == GL_TRIANGLES ? count - count % 3 : count,
                                                                first);
    }
};

struct PositionTriangles
{
    std::vector<std::array<osg::Vec3, 3>> positions;
    void operator()(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, bool = false)
    {
        positions.push_back({a, b, c});
    }
};

bool isInRange(const SceneVertex& vertex)
{
    // Written so that NaN fails it.
    return glm::all(glm::lessThanEqual(glm::abs(vertex.position), glm::dvec3(SceneVertex::MAXIMUM_COORDINATE)));
}

glm::dvec3 toGlm(const osg::Vec3d& vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

/** Reads the vertices of a geometry from arrays of any type. */
class VertexReader
{
public:
    VertexReader(const osg::Geometry& geometry, const osg::Matrixd& toRoot, const SurfaceState& state) :
        _positions(*geometry.getVertexArray()), _colors(state.usesColorArray() ? colorsOf(geometry) : nullptr),
        _coordinates(geometry.getTexCoordArray(state.getTextureUnit())), _toRoot(toRoot), _stateColor(state.getColor()),
        _textureMatrix(state.getTextureMatrix()), _isTextured(state.getTexture() != nullptr)
    {
    }

    unsigned int getNumVertices() const { return _positions.getNumElements(); }
    /** The number of vertices read whose colour or texture coordinate had to be replaced. */
    std::size_t getNumReplaced() const { return _replaced.size(); }

    SceneVertex read(unsigned int vertex, unsigned int primitiveSet)
    {
        SceneVertex result;
        glm::dvec4 element(0.0);
        readElement(_positions, vertex, IntegerMeaning::VALUE, element);
        result.position = toGlm(osg::Vec3d(element.x, element.y, element.z) * _toRoot);
        result.color = readColor(vertex, primitiveSet);
        result.coordinate = readCoordinate(vertex);
        return result;
    }

private:
    static const osg::Array* colorsOf(const osg::Geometry& geometry)
    {
        const osg::Array* colors = geometry.getColorArray();
        return colors && colors->getBinding() != osg::Array::BIND_OFF ? colors : nullptr;
    }

    glm::vec3 readColor(unsigned int vertex, unsigned int primitiveSet)
    {
        glm::dvec4 color(_stateColor.x(), _stateColor.y(), _stateColor.z(), 1.0);
        if (_colors) readElement(*_colors, colorIndex(vertex, primitiveSet), IntegerMeaning::FRACTION, color);
        glm::vec3 result;
        for (int channel = 0; channel < 3; ++channel)
        {
            if (!std::isfinite(color[channel])) _replaced.insert(vertex);
            result[channel] = static_cast<float>(toColorFraction(color[channel]));
        }
        return result;
    }

    unsigned int colorIndex(unsigned int vertex, unsigned int primitiveSet) const
    {
        switch (_colors->getBinding())
        {
        case osg::Array::BIND_OVERALL:
            return 0;
        case osg::Array::BIND_PER_PRIMITIVE_SET:
            return primitiveSet;
        case osg::Array::BIND_PER_VERTEX:
            return vertex;
        default:
            return _colors->getNumElements() == 1 ? 0 : vertex;
        }
    }

    glm::vec2 readCoordinate(unsigned int vertex)
    {
        glm::dvec4 coordinate(0.0, 0.0, 0.0, 1.0);
        if (_coordinates) readElement(*_coordinates, vertex, IntegerMeaning::VALUE, coordinate);
        if (_textureMatrix)
        {
            const osg::Vec4d moved = osg::Vec4d(coordinate.x, coordinate.y, coordinate.z, coordinate.w) *
                                     osg::Matrixd(_textureMatrix->getMatrix());
            coordinate = glm::dvec4(moved.x(), moved.y(), moved.z(), moved.w());
        }
        const glm::dvec2 result(glm::dvec2(coordinate) / (coordinate.w == 0.0 ? 1.0 : coordinate.w));
        // Written so that NaN fails it.
        if (glm::all(glm::lessThanEqual(glm::abs(result), glm::dvec2(SceneVertex::MAXIMUM_COORDINATE))))
            return {result};
        if (_isTextured) _replaced.insert(vertex);
        return glm::vec2(0.0f);
    }

    const osg::Array& _positions;
    const osg::Array* _colors;
    const osg::Array* _coordinates;
    const osg::Matrixd& _toRoot;
    osg::Vec4d _stateColor;
    const osg::TexMat* _textureMatrix;
    bool _isTextured;
    std::set<unsigned int> _replaced;
};

} // namespace

void SceneTriangleCollector::applySurface(const osg::Drawable& drawable, const osg::Matrixd& toRoot,
                                          const std::vector<const osg::StateSet*>& stateSets)
{
    const SurfaceState state(stateSets);
    const osg::Geometry* geometry = drawable.asGeometry();
    if (!geometry)
    {
        collectShape(drawable, toRoot, state);
        return;
    }
    if (geometry->containsDeprecatedData())
    {
        osg::ref_ptr<osg::Geometry> modern = new osg::Geometry(*geometry, osg::CopyOp::DEEP_COPY_ALL);
        modern->fixDeprecatedData();
        collectGeometry(*modern, toRoot, state);
        return;
    }
    collectGeometry(*geometry, toRoot, state);
}

void SceneTriangleCollector::collectGeometry(const osg::Geometry& geometry, const osg::Matrixd& toRoot,
                                             const SurfaceState& state)
{
    if (!geometry.getVertexArray()) return;
    SceneBatch& batch = findOrMakeBatch(state, geometry.getTexCoordArray(state.getTextureUnit()) != nullptr);
    VertexReader reader(geometry, toRoot, state);
    std::set<unsigned int> badVertices;
    for (unsigned int set = 0; set < geometry.getNumPrimitiveSets(); ++set)
    {
        WholeTriangles functor(reader.getNumVertices());
        geometry.getPrimitiveSet(set)->accept(functor);
        for (const auto& indices : functor.indices)
        {
            const std::array corners{reader.read(indices[0], set), reader.read(indices[1], set),
                                     reader.read(indices[2], set)};
            if (addTriangle(batch, corners)) continue;
            for (std::size_t corner = 0; corner < 3; ++corner)
                if (!isInRange(corners[corner])) badVertices.insert(indices[corner]);
        }
    }
    _contents.numBadVertices += badVertices.size();
    _contents.numReplaced += reader.getNumReplaced();
}

void SceneTriangleCollector::collectShape(const osg::Drawable& drawable, const osg::Matrixd& toRoot,
                                          const SurfaceState& state)
{
    osg::TriangleFunctor<PositionTriangles> functor;
    if (!drawable.supports(functor)) return;
    drawable.accept(functor);

    SceneBatch& batch = findOrMakeBatch(state, false);
    SceneVertex vertex;
    const osg::Vec4d color = state.getColor();
    vertex.color = glm::vec3(color.x(), color.y(), color.z());
    for (const auto& triangle : functor.positions)
    {
        std::array<SceneVertex, 3> corners{vertex, vertex, vertex};
        for (std::size_t corner = 0; corner < 3; ++corner)
            corners[corner].position = toGlm(osg::Vec3d(triangle[corner]) * toRoot);
        if (addTriangle(batch, corners)) continue;
        _contents.numBadVertices +=
            static_cast<std::size_t>(std::count_if(corners.begin(), corners.end(), std::not_fn(isInRange)));
    }
}

SceneBatch& SceneTriangleCollector::findOrMakeBatch(const SurfaceState& state, bool hasCoordinates)
{
    osg::ref_ptr<const SurfaceTexture> texture;
    if (state.getTexture() && hasCoordinates) texture = _textures.findOrMake(*state.getTexture());
    const TextureEnvironment environment = texture ? state.getEnvironment() : TextureEnvironment::MODULATE;

    const auto [place, isNew] =
        _batchIndices.try_emplace(BatchKey(texture.get(), environment), _contents.batches.size());
    if (isNew) _contents.batches.push_back({texture, environment, {}});
    return _contents.batches[place->second];
}

bool SceneTriangleCollector::addTriangle(SceneBatch& batch, const std::array<SceneVertex, 3>& corners)
{
    if (!std::all_of(corners.begin(), corners.end(), isInRange))
    {
        ++_contents.numOutOfRange;
        return false;
    }
    const auto& [a, b, c] = corners;
    if (glm::cross(b.position - a.position, c.position - a.position) == glm::dvec3(0.0)) return true;

    for (const SceneVertex& vertex : corners)
    {
        batch.vertices.push_back(vertex);
        _contents.bounds.expandBy(vertex.position.x, vertex.position.y, vertex.position.z);
    }
    ++_contents.numTriangles;
    return true;
}

} // namespace osgLego
