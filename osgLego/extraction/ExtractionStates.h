#pragma once

#include <osgLego/passes/PassPlan.h>

#include <osg/Referenced>
#include <osg/State>
#include <osg/StateSet>
#include <osg/Texture2D>
#include <osg/ref_ptr>

namespace osgLego
{

/** The state sets of the extraction: its programs and their input. The passes of all slabs share them, so that they are
 * compiled once.
 *
 * Can be created without a context.
 */
class ExtractionStates : public osg::Referenced
{
public:
    /** @param voxelImage the image of PassPlan::getExtractedFormat(). */
    ExtractionStates(osg::Texture2D& voxelImage, const PassPlan& plan);

    /** Computes the occupancy from the voxel image, for contexts in which voxelization can't mark cells. */
    osg::StateSet& getOccupancy() const { return *_occupancy; }
    /** Captures the numbers of the non-empty words of the occupancy. */
    osg::StateSet& getWords() const { return *_words; }
    /** Captures the bricks of these words. */
    osg::StateSet& getBricks() const { return *_bricks; }
    /** Captures the neighbours of bricks. */
    osg::StateSet& getNeighbors() const { return *_neighbors; }

    void releaseGLObjects(osg::State* state) const;
    void resizeGLObjectBuffers(unsigned int maxSize) const;

private:
    ~ExtractionStates() override = default;

    osg::ref_ptr<osg::StateSet> _occupancy;
    osg::ref_ptr<osg::StateSet> _words;
    osg::ref_ptr<osg::StateSet> _bricks;
    osg::ref_ptr<osg::StateSet> _neighbors;
};

} // namespace osgLego
