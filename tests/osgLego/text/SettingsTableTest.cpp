#include <osgLego/text/SettingValues.h>
#include <osgLego/text/SettingsTable.h>

#include <limits>
#include <optional>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

enum class Fence
{
    HEDGE,
    WALL,
    WIRE
};

/** Settings with every kind of values, in a group and outside one. */
struct Garden
{
    struct Pond
    {
        double depth = 0.5;
        std::optional<Fence> fence;
    };

    unsigned int area = 10;
    bool hasPaths = true;
    Pond pond;
};

SettingsTable<Garden> createTable()
{
    SettingsTable<Garden> table;
    table.add("area", &Garden::area, NumberRange(1u, 500u, "square metres"), "the area with the paths");
    table.add("paths", &Garden::hasPaths, Switch(), "whether there are paths");
    SettingsGroup pond(table, "pond", &Garden::pond);
    pond.add("depth", &Garden::Pond::depth, NumberRange(0.25, 2.0), "the depth of the pond");
    pond.add("fence", &Garden::Pond::fence,
             Choice<Fence>{{"hedge", Fence::HEDGE}, {"wall", Fence::WALL}, {"wire", Fence::WIRE}},
             "the fence around the pond", "none");
    return table;
}

TEST(SettingsTable, DescribesItsKeysInTheirOrder)
{
    using Range = SettingRange;
    using Type = SettingType;
    const SettingDescriptions expected = {
        {"area", "", "<number>", "1 to 500 square metres", "10", "the area with the paths", Type::WHOLE_NUMBER,
         Range{1.0, 500.0}},
        {"paths", "", "off|on", "off, on", "on", "whether there are paths", Type::SWITCH, {}, {"off", "on"}},
        {"depth", "pond", "<number>", "0.25 to 2", "0.5", "the depth of the pond", Type::NUMBER, Range{0.25, 2.0}},
        {"fence",
         "pond",
         "hedge|wall|wire",
         "hedge, wall, wire",
         "none",
         "the fence around the pond",
         Type::CHOICE,
         {},
         {"hedge", "wall", "wire"}}};
    EXPECT_EQ(createTable().describe(), expected);
}

TEST(SettingsTable, ReadsValuesOfEveryKind)
{
    const SettingsTable<Garden> table = createTable();
    Garden garden;
    EXPECT_EQ(table.read("area", "20", garden), "");
    EXPECT_EQ(table.read("paths", "off", garden), "");
    EXPECT_EQ(table.read("depth", "1.5", garden), "");
    EXPECT_EQ(table.read("fence", "wire", garden), "");
    EXPECT_EQ(garden.area, 20u);
    EXPECT_FALSE(garden.hasPaths);
    EXPECT_EQ(garden.pond.depth, 1.5);
    EXPECT_EQ(garden.pond.fence, Fence::WIRE);
}

TEST(SettingsTable, NamesTheExpectedValuesInErrors)
{
    const SettingsTable<Garden> table = createTable();
    Garden garden;
    EXPECT_EQ(table.read("area", "1.5", garden),
              "bad value '1.5' for area; expected a whole number of square metres, 1 to 500");
    EXPECT_EQ(table.read("paths", "yes", garden), "bad value 'yes' for paths; expected off or on");
    EXPECT_EQ(table.read("depth", "1m", garden), "bad value '1m' for depth; expected a number, 0.25 to 2");
    EXPECT_EQ(table.read("fence", "", garden), "bad value '' for fence; expected hedge, wall or wire");
    EXPECT_EQ(table.read("tree", "oak", garden), "unknown key 'tree'; the keys are area, paths, depth, fence");
}

TEST(SettingsTable, ChecksRangesWithTheirLimits)
{
    const SettingsTable<Garden> table = createTable();
    const auto errorOf = [&table](unsigned int area, double depth)
    {
        Garden garden;
        garden.area = area;
        garden.pond.depth = depth;
        return table.check(garden);
    };
    EXPECT_EQ(errorOf(1, 0.25), "");
    EXPECT_EQ(errorOf(500, 2.0), "");
    EXPECT_EQ(errorOf(0, 1.0), "bad value '0' for area; expected a whole number of square metres, 1 to 500");
    EXPECT_EQ(errorOf(501, 1.0), "bad value '501' for area; expected a whole number of square metres, 1 to 500");
    EXPECT_EQ(errorOf(1, 0.125), "bad value '0.125' for depth; expected a number, 0.25 to 2");
    EXPECT_EQ(errorOf(1, std::numeric_limits<double>::quiet_NaN()),
              "bad value 'nan' for depth; expected a number, 0.25 to 2");
}

TEST(SettingsTable, WritesTheFirstValueAndThoseThatAreNotTheDefault)
{
    const SettingsTable<Garden> table = createTable();
    Garden garden;
    EXPECT_EQ(table.write(garden), "10");
    EXPECT_EQ(table.write(garden, false), "");
    garden.pond.fence = Fence::HEDGE;
    garden.hasPaths = false;
    EXPECT_EQ(table.write(garden), "10,paths=off,fence=hedge");
    EXPECT_EQ(table.write(garden, false), "paths=off,fence=hedge");
}

} // namespace

} // namespace osgLego
