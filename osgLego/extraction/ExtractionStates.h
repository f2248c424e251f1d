#pragma once

#include <osg/Referenced>
#include <osg/State>
#include <osg/StateSet>
#include <osg/Texture2D>
#include <osg/ref_ptr>

namespace osgLego
{

/** The programs of the extraction and what they read; the passes of all slabs share them, and so compile them once.
 *
 * Needs no context to be made.
 */
class ExtractionStates : public osg::Referenced
{
public:
    explicit ExtractionStates(osg::Texture2D& voxelImage);

    /** The occupancy out of the voxel image, for contexts in which voxelization can't mark it. */
    osg::StateSet& getOccupancy() const { return *_occupancy; }
    /** Those words of the occupancy that are not empty. */
    osg::StateSet& getWords() const { return *_words; }
    /** The bricks of those. */
    osg::StateSet& getBricks() const { return *_bricks; }

    void releaseGLObjects(osg::State* state) const;
    void resizeGLObjectBuffers(unsigned int maxSize) const;

private:
    ~ExtractionStates() override = default;

    osg::ref_ptr<osg::StateSet> _occupancy;
    osg::ref_ptr<osg::StateSet> _words;
    osg::ref_ptr<osg::StateSet> _bricks;
};

} // namespace osgLego
