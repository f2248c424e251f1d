#pragma once

#include <ldraw/LDrawScene.h>
#include <ldraw/LDrawWriteOptions.h>
#include <osgLego/LegoNode.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace osgLego::test
{

/** A part of LDraw's colour `code`. */
Part makePart(const std::array<std::uint16_t, 3>& cell, const std::array<std::uint8_t, 3>& size, std::int32_t code);

/** A node of parts. @param height of a cell; a brick's or a plate's. */
osg::ref_ptr<LegoNode> createNode(const glm::ivec3& dimensions, std::vector<Part> parts, double height = 1.2,
                                  UpAxis up = UpAxis::Z);

using Lines = std::vector<std::string>;

/** A scene, and the file that LDrawWriter makes of it. */
struct WrittenLDraw
{
    LDrawScene scene;
    std::string text;

    /** The lines that place parts, without ends of lines. */
    std::vector<std::string> getReferences() const { return getLines('1'); }
    std::vector<std::string> getLines(char type) const;
};

/** Write a node to a file that LDrawWriter::check() accepts. */
WrittenLDraw writeLDraw(const osg::Node& node, const std::string& name = "a.ldr",
                        const LDrawWriteOptions& options = {});

} // namespace osgLego::test
