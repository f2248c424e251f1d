#include <osgLego/flattening/SourceSignature.h>

#include <osgLego/flattening/SourceVisitor.h>
#include <osgLego/flattening/SurfaceState.h>

#include <bit>
#include <cstring>
#include <utility>

#include <osg/Geometry>

namespace osgLego
{

namespace
{

/** Hashes a sequence of numbers, with the multiplications and shifts of MurmurHash's 64-bit finalizer. */
class Signature
{
public:
    void add(std::uint64_t value)
    {
        std::uint64_t mixed = (_signature.value ^ value) * 0xff51afd7ed558ccdull;
        mixed ^= mixed >> 33;
        mixed *= 0xc4ceb9fe1a85ec53ull;
        _signature.value = mixed ^ (mixed >> 29);
    }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    void add(const osg::Referenced* object)
    {
        add(static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(object)));
        if (object) _signature.objects.emplace_back(object);
    }
    void add(const osg::Matrixd& matrix)
    {
        for (int element = 0; element < 16; ++element)
            add(matrix.ptr()[element]);
    }
    void add(const osg::Vec4d& vector)
    {
        for (unsigned int component = 0; component < 4; ++component)
            add(vector[component]);
    }
    void addBytes(const void* data, std::size_t size)
    {
        const auto* bytes = static_cast<const unsigned char*>(data);
        for (std::size_t offset = 0; offset < size; offset += sizeof(std::uint64_t))
        {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes + offset, std::min(size - offset, sizeof(word)));
            add(word);
        }
    }

    const SourceSignature& get() const { return _signature; }
    void clear()
    {
        _signature.value = 0;
        _signature.objects.clear();
    }

private:
    SourceSignature _signature;
};

class SignatureVisitor : public SourceVisitor
{
public:
    META_NodeVisitor(osgLego, SignatureVisitor)

    explicit SignatureVisitor(bool isByContents = false) : _isByContents(isByContents) {}

    Signature& getSignature() { return _signature; }

protected:
    void applySurface(const osg::Drawable& drawable, const osg::Matrixd& toRoot,
                      const std::vector<const osg::StateSet*>& stateSets) override
    {
        _signature.add(static_cast<const osg::Referenced*>(&drawable));
        _signature.add(toRoot);
        const SurfaceState state(stateSets);
        addState(state);
        if (const osg::Geometry* geometry = drawable.asGeometry()) addGeometry(*geometry, state.getTextureUnit());
    }

private:
    void addState(const SurfaceState& state)
    {
        _signature.add(state.getColor());
        _signature.add(std::uint64_t(state.usesColorArray()));
        _signature.add(static_cast<std::uint64_t>(state.getEnvironment()));
        _signature.add(static_cast<const osg::Referenced*>(state.getTexture()));
        if (const osg::Texture2D* texture = state.getTexture())
        {
            _signature.add(static_cast<const osg::Referenced*>(texture->getImage()));
            _signature.add(std::uint64_t(texture->getImage() ? texture->getImage()->getModifiedCount() : 0));
            _signature.add(std::uint64_t(texture->getWrap(osg::Texture::WRAP_S)));
            _signature.add(std::uint64_t(texture->getWrap(osg::Texture::WRAP_T)));
            _signature.add(osg::Vec4d(texture->getBorderColor()));
        }
        if (state.getTextureMatrix()) _signature.add(osg::Matrixd(state.getTextureMatrix()->getMatrix()));
    }

    void addGeometry(const osg::Geometry& geometry, unsigned int textureUnit)
    {
        const bool byContents = _isByContents || geometry.getDataVariance() == osg::Object::DYNAMIC;
        addData(geometry.getVertexArray(), byContents);
        addData(geometry.getColorArray(), byContents);
        addData(geometry.getTexCoordArray(textureUnit), byContents);
        if (geometry.getColorArray()) _signature.add(std::uint64_t(geometry.getColorArray()->getBinding()));
        for (const osg::ref_ptr<osg::PrimitiveSet>& set : geometry.getPrimitiveSetList())
        {
            addData(set.get(), byContents);
            _signature.add(std::uint64_t(set->getMode()));
            _signature.add(std::uint64_t(set->getNumIndices()));
            if (set->getNumIndices() > 0) _signature.add(std::uint64_t(set->index(0)));
        }
    }

    void addData(const osg::BufferData* data, bool byContents)
    {
        _signature.add(static_cast<const osg::Referenced*>(data));
        if (!data) return;
        _signature.add(std::uint64_t(data->getModifiedCount()));
        _signature.add(std::uint64_t(data->getTotalDataSize()));
        if (byContents && data->getDataPointer()) _signature.addBytes(data->getDataPointer(), data->getTotalDataSize());
    }

    bool _isByContents = false; // whether this holds for all geometries
    Signature _signature;
};

} // namespace

SourceSignature computeSourceSignature(const osg::Node& node)
{
    return SourceSignatures().compute(node);
}

std::uint64_t hashSourceContents(const osg::Node& node)
{
    SignatureVisitor visitor(true);
    // accept() is not const, but the visitor only reads.
    const_cast<osg::Node&>(node).accept(visitor);
    return visitor.getSignature().get().value;
}

SourceSignatures::SourceSignatures() : _visitor(new SignatureVisitor) {}

SourceSignatures::~SourceSignatures() = default;

const SourceSignature& SourceSignatures::compute(const osg::Node& node)
{
    Signature& signature = static_cast<SignatureVisitor&>(*_visitor).getSignature();
    signature.clear();
    // accept() is not const, but the visitor only reads.
    const_cast<osg::Node&>(node).accept(*_visitor);
    return signature.get();
}

} // namespace osgLego
