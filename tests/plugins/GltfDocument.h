#pragma once

#include <string>
#include <vector>

#include <osg/Vec2>
#include <osg/Vec3>
#include <osg/Vec4>

namespace osgLego::test
{

/** Writes small documents of glTF 2.0 for tests of its readers. */
class GltfDocument
{
public:
    /** Add an array of vertices. @return the number of its accessor. */
    int add(const std::vector<osg::Vec3>& values);
    int add(const std::vector<osg::Vec2>& values);
    int add(const std::vector<osg::Vec4>& values);
    int addIndices(const std::vector<unsigned short>& values);
    /** Add the bytes of a .png file. */
    void addPicture(const std::string& bytes);
    /** Refer to a picture in a file of its own. */
    void addPictureFile(const std::string& uri);
    /** Add a primitive to the only mesh. @param attributes such as "POSITION":0 @param rest such as "indices":1 */
    void addPrimitive(const std::string& attributes, const std::string& rest = {}, int materialNumber = 0);

    std::string material = "{}";             //!< a JSON object, or several with commas between them
    std::string nodes = R"([{"mesh":0}])";   //!< the first is the root
    std::string texture = R"({"source":0})"; //!< the only texture, if there is a picture
    std::string samplers = R"([{"wrapS":33071}])";

    /** The text of a .gltf file. @param buffer the URI of its buffer; empty in a .glb file. */
    std::string toText(const std::string& buffer) const;
    /** The bytes of a .glb file. */
    std::string toBinary() const;
    const std::string& getBuffer() const { return _buffer; }

private:
    int addView(const void* data, std::size_t size);
    int addAccessor(const void* data, std::size_t count, std::size_t size, const std::string& description);

    std::string _buffer;
    std::string _views;
    std::string _accessors;
    std::string _primitives;
    std::string _image;
    int _numViews = 0;
    int _numAccessors = 0;
};

} // namespace osgLego::test
