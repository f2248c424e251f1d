#pragma once

#include <string>

#include <osg/Object>

namespace osgLego
{

/** The texts that an author gives a model, as at the beginning of a file of LDraw. Those that are missing are empty.
 *
 * A LegoNode has them as user values, "title", "author" and "license": the reader of LDraw's files stores them, and
 * booklets and the writer of such files find them. */
struct ModelHeader
{
    std::string title;
    std::string author;
    std::string license; //!< the text after !LICENSE

    /** The texts that an object has. */
    static ModelHeader find(const osg::Object& object);
    /** Give an object the texts that are not empty. */
    void store(osg::Object& object) const;
    /** Take the texts of another header that are missing here. */
    void complete(const ModelHeader& other);
    /** Remove the texts that differ from those of another header. */
    void keepEqual(const ModelHeader& other);
};

} // namespace osgLego
