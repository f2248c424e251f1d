#include <common/JsonValue.h>

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

TEST(JsonValue, WritesEveryTypeAndKeepsTheOrderOfMembers)
{
    JsonValue value{{"text", "a \"quoted\"\nline"}, {"yes", true}, {"integer", std::size_t{3}}, {"number", 2.0}};
    value["none"];
    value["array"] = JsonValue::createArray({1, "two", JsonValue::createArray()});
    value["empty"] = JsonValue::createObject();
    value["nested"] = {{"z", -1}, {"a", {{"b", 0.5}}}};
    EXPECT_EQ(value.toString(), R"({"text":"a \"quoted\"\nline","yes":true,"integer":3,"number":2.0,"none":null,)"
                                R"("array":[1,"two",[]],"empty":{},"nested":{"z":-1,"a":{"b":0.5}}})");
    EXPECT_EQ((JsonValue{{"a", 1}}.toString(2)), "{\n  \"a\": 1\n}");
    EXPECT_EQ(JsonValue(std::numeric_limits<double>::quiet_NaN()).toString(), "null");
}

TEST(JsonValue, ReadsWhatItWrites)
{
    const std::string text = R"({"z":[1,2.5,"x",null,false],"a":{"deep":[[-7]]}})";
    const std::optional<JsonValue> value = JsonValue::parse(text);
    ASSERT_TRUE(value);
    EXPECT_EQ(value->toString(), text);
    EXPECT_EQ((*value)["a"]["deep"].getElements()[0].getElements()[0].toInteger(), -7);
    EXPECT_FALSE(JsonValue::parse("{\"a\":"));
    EXPECT_FALSE(JsonValue::parse(""));
}

TEST(JsonValue, ReplacesMembersOfTheSameNameInPlace)
{
    JsonValue value{{"a", 1}, {"b", 2}};
    value.update({{"a", 3}, {"c", 4}});
    value["b"] = "five";
    EXPECT_EQ(value.toString(), R"({"a":3,"b":"five","c":4})");
}

TEST(JsonValue, ReplacesBytesThatAreNotUtf8)
{
    const JsonValue value{{"a\xff", "b\xfc"
                                    "c"}};
    EXPECT_EQ(value.toString(), "{\"a\xef\xbf\xbd\":\"b\xef\xbf\xbd"
                                "c\"}");
}

TEST(JsonValue, RefusesToReadAnotherType)
{
    const JsonValue value{{"text", "1"}, {"integer", 1}};
    EXPECT_EQ(value["integer"].toNumber(), 1.0);
    EXPECT_THROW(value["text"].toNumber(), std::logic_error);
    EXPECT_THROW(value["integer"].toText(), std::logic_error);
    EXPECT_THROW(value["integer"].toBoolean(), std::logic_error);
    EXPECT_THROW(value["missing"], std::logic_error);
    EXPECT_THROW(JsonValue(1).append(2), std::logic_error);
    EXPECT_FALSE(value.contains("missing"));
}

} // namespace

} // namespace osgLego
