#pragma once

#include <assimp/DefaultIOSystem.h>
#include <osg/ref_ptr>
#include <osgDB/Options>

/** Opens the files to which a model refers: in the folder of the model, or where osgDB finds them. One thread. */
class AssimpFiles : public Assimp::DefaultIOSystem
{
public:
    /** @param options whose database path begins with the folder of the model. */
    explicit AssimpFiles(const osgDB::Options& options);

    bool Exists(const char* name) const override;
    Assimp::IOStream* Open(const char* name, const char* mode) override;

private:
    std::string find(const char* name) const;

    osg::ref_ptr<const osgDB::Options> _options;
};
