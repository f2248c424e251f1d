#include <booklet/TrueSizePicture.h>

#include <regex>

#include <gtest/gtest.h>

namespace osgLego
{

TEST(TrueSizePictureTest, IsAsLargeAsParts)
{
    const std::string picture =
        drawTrueSize({findPartType(PartFamily::PLATE, 1, 6), findPartType(PartFamily::BRICK, 2, 8)});
    std::smatch found;
    // A unit is a millimetre.
    ASSERT_TRUE(std::regex_search(
        picture, found, std::regex(R"x(width:([\d.]+)mm;height:([\d.]+)mm" viewBox="-?[\d.]+ 0 ([\d.]+) ([\d.]+)")x")));
    EXPECT_EQ(found[1], found[3]);
    EXPECT_EQ(found[2], found[4]);
    EXPECT_NEAR(std::stod(found[1]), 64.0, 0.3) << "eight studs";
    // Plates are 3.2 mm high and bricks 9.6 mm, a plate of six studs 48 mm wide, less the gap to its neighbours.
    const std::regex outline(R"(d="M([\d.]+) ([\d.]+)V([\d.]+)[^"]*?H([\d.]+)V[\d.]+Z")");
    std::vector<std::pair<double, double>> sizes;
    for (auto part = std::sregex_iterator(picture.begin(), picture.end(), outline); part != std::sregex_iterator();
         ++part)
        sizes.emplace_back(std::stod((*part)[4]) - std::stod((*part)[1]),
                           std::stod((*part)[2]) - std::stod((*part)[3]));
    ASSERT_EQ(sizes.size(), 2u);
    EXPECT_NEAR(sizes[0].first, 48.0 - 0.2, 0.05);
    EXPECT_NEAR(sizes[0].second, 3.2, 0.011);
    EXPECT_NEAR(sizes[1].first, 64.0 - 0.2, 0.05);
    EXPECT_NEAR(sizes[1].second, 9.6, 0.011);
    EXPECT_NE(picture.find("<text x=\"4.0\""), std::string::npos) << "the number of the first stud is in its middle";
    EXPECT_NE(picture.find("<text x=\"60.0\""), std::string::npos) << "and that of the last one";
}

} // namespace osgLego
