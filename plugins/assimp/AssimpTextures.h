#pragma once

#include <map>
#include <string>

#include <assimp/scene.h>
#include <osg/Image>
#include <osg/Texture2D>
#include <osg/ref_ptr>
#include <osgDB/Options>

/** The images that the materials of a scene refer to, embedded in its file or in other files. One thread. */
class AssimpTextures
{
public:
    /** @param scene must outlive this object. @param name of its file, for warnings.
     * @param options find and read other files. */
    AssimpTextures(const aiScene& scene, std::string name, const osgDB::Options& options);

    /** Read an image; each is read once. @return null, with one warning, if that fails. */
    osg::ref_ptr<osg::Image> read(const std::string& reference);

private:
    std::string find(const std::string& path) const;
    osg::ref_ptr<osg::Image> readFile(const std::string& reference, std::string& error) const;

    const aiScene& _scene;
    std::string _name;
    osg::ref_ptr<const osgDB::Options> _options;
    std::map<std::string, osg::ref_ptr<osg::Image>> _images;
};
