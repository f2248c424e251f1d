#pragma once

#include <osgLego/BrickCodec.h>
#include <osgLego/CpuLegolizer.h>

#include <Meshes.h>
#include <Settings.h>

#include <string>

namespace osgLego::test
{

/** A model of a few parts. */
inline osg::ref_ptr<const BrickModel> createSmallModel()
{
    return legolizeOnCpu(*createSphere(4), parseSettings("3,proportions=plate,parts=bricks,fill=solid"));
}

/** The bytes of a model, if there is one. */
inline std::string encode(const osg::ref_ptr<const BrickModel>& model)
{
    return model ? encodeBricks(*model) : std::string();
}

} // namespace osgLego::test
