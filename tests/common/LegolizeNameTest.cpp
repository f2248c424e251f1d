#include <common/LegolizeName.h>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

void expectParsed(const std::string& name, const std::string& fileName, const std::string& settings)
{
    LegolizeName parsed;
    ASSERT_TRUE(LegolizeName::parse(name, parsed)) << name;
    EXPECT_EQ(parsed.fileName, fileName) << name;
    EXPECT_EQ(parsed.settings, settings) << name;
}

TEST(LegolizeName, TellsTheFileFromTheSettings)
{
    expectParsed("model.ply.legolize", "model.ply", "");
    expectParsed("model.ply.LEGOLIZE", "model.ply", "");
    expectParsed("model.ply.64.legolize", "model.ply", "64");
    expectParsed("model.ply.(64,proportions=plate,up=y).legolize", "model.ply", "64,proportions=plate,up=y");
    expectParsed("model.ply.[64,edge=0.5].legolize", "model.ply", "64,edge=0.5");
    expectParsed("model.ply.(cell=0.5,origin=-1:.2:3,size=4:5:6).legolize", "model.ply",
                 "cell=0.5,origin=-1:.2:3,size=4:5:6");
    expectParsed("model.ply.up=y.legolize", "model.ply", "up=y");
    expectParsed("model.ply.().legolize", "model.ply", "");
    expectParsed("/a.b/c.(d)/model.ply.(32).legolize", "/a.b/c.(d)/model.ply", "32");
    expectParsed("/a.64/model.legolize", "/a.64/model", "");
    expectParsed("car.3ds.legolize", "car.3ds", "");
    expectParsed("cow.osg.(0,0,90).rot.64.legolize", "cow.osg.(0,0,90).rot", "64");
    expectParsed("bunny.ply.8.legolize.16.legolize", "bunny.ply.8.legolize", "16");
    expectParsed("sample.legolize", "sample", "");
    expectParsed("model.ply.(64,probe=../sky/my.park(2).exr).legolize", "model.ply", "64,probe=../sky/my.park(2).exr");
    expectParsed("model.ply.occlusion=off.legolize", "model.ply", "occlusion=off");
}

TEST(LegolizeName, OtherNamesAreNone)
{
    LegolizeName parsed;
    for (const char* name : {"model.ply", "legolize", ".legolize", "(64).legolize.ply", ".64.legolize"})
        EXPECT_FALSE(LegolizeName::parse(name, parsed)) << name;
}

TEST(LegolizeName, ABracketWithoutItsCounterpartIsNamedWithItsPlace)
{
    EXPECT_EQ(LegolizeName::findLoneBracket("a.obj.(8,up=y.legolize"),
              "'(' as character 7 of 'a.obj.(8,up=y.legolize' is not closed; expected ')' before '.legolize'");
    EXPECT_EQ(LegolizeName::findLoneBracket("a.obj.[8,edge=0.5.legolize"),
              "'[' as character 7 of 'a.obj.[8,edge=0.5.legolize' is not closed; expected ']' before '.legolize'");
    EXPECT_EQ(LegolizeName::findLoneBracket("a.obj.8).legolize"),
              "')' as character 8 of 'a.obj.8).legolize' has no opening bracket; expected '(' before it");
    EXPECT_EQ(LegolizeName::findLoneBracket("a.obj.(8].legolize"),
              "']' as character 9 of 'a.obj.(8].legolize' closes '('; expected ')'");
    for (const char* name : {"a.obj.(8).legolize", "a.obj.(8).[9].legolize", "b(c/a.obj.8.legolize"})
        EXPECT_EQ(LegolizeName::findLoneBracket(name), "");
}

} // namespace

} // namespace osgLego
