#include "WrittenLDraw.h"

#include <ldraw/LDrawWriter.h>

#include <PartModels.h>

#include <sstream>

#include <gtest/gtest.h>

namespace osgLego::test
{

Part makePart(const std::array<std::uint16_t, 3>& cell, const std::array<std::uint8_t, 3>& size, std::int32_t code)
{
    return {cell, size, {200, 30, 20}, code};
}

osg::ref_ptr<LegoNode> createNode(const glm::ivec3& dimensions, std::vector<Part> parts, double height, UpAxis up)
{
    const auto model = BrickModel::createOfParts(createPartGrid(dimensions, height, up), std::move(parts));
    return createStoredNode(*model, "parts=bricks");
}

std::vector<std::string> WrittenLDraw::getLines(char type) const
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        if (line.front() == type) lines.push_back(line.substr(0, line.find_last_not_of('\r') + 1));
    return lines;
}

WrittenLDraw writeLDraw(const osg::Node& node, const std::string& name, const LDrawWriteOptions& options)
{
    WrittenLDraw written;
    std::string error;
    EXPECT_TRUE(LDrawScene::create(node, written.scene, error)) << error;
    std::ostringstream stream;
    const LDrawWriter writer(written.scene, name, options);
    writer.write(stream);
    written.text = stream.str();
    EXPECT_EQ(writer.check(written.text), "");
    return written;
}

} // namespace osgLego::test
