#pragma once

#include <osgLego/data/ByteReader.h>

#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego::fuzz
{

/** A mesh that bytes describe: an osg::Geometry with any arrays and primitive sets, below a transform and with a
 * texture or without. Indices may be beyond the arrays, arrays may be missing or too short, and numbers may not be
 * finite. Bytes beyond the end are zeros. */
osg::ref_ptr<osg::Node> createRandomMesh(ByteReader& reader);

} // namespace osgLego::fuzz
