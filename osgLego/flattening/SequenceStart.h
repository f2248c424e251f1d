#pragma once

#include <algorithm>
#include <optional>

#include <osg/Sequence>

namespace osgLego
{

/** The child with which a sequence begins at its first update, before which osg::Sequence::getValue() is that of no
 * child. @return nothing if it has begun, will not begin, or has no children. */
inline std::optional<unsigned int> findSequenceStart(const osg::Sequence& sequence)
{
    const bool begins = sequence.getValue() < 0 && sequence.getMode() == osg::Sequence::START;
    if (!begins || sequence.getNumChildren() == 0) return std::nullopt;
    osg::Sequence::LoopMode mode = osg::Sequence::LOOP;
    int first = 0;
    int last = 0;
    sequence.getInterval(mode, first, last);
    const int end = static_cast<int>(sequence.getNumChildren()) - 1;
    return static_cast<unsigned int>(std::clamp(first < 0 ? end : first, 0, end)); // -1 means the last child
}

} // namespace osgLego
