#include <osgLego/StabilityReport.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

TEST(StabilityReport, SaysWhetherAModelStandsFallsOrThatThisIsUnknown)
{
    StabilityReport report;
    EXPECT_EQ(report.toString(), "the model stands safely, with a margin of 100 %");
    report.margin = 0.1;
    report.safe = false;
    EXPECT_EQ(report.toString(), "the model stands, but not safely, with a margin of 10 %");
    report.stands = false;
    report.unknown = {3};
    EXPECT_EQ(report.toString(), "it is unknown whether the model stands; 1 part is in a piece whose forces can't be "
                                 "computed precisely enough");
    EXPECT_FALSE(report.falls());
    report.falling = {1, 2};
    EXPECT_EQ(report.toString(), "the model falls: 2 parts are not held; 1 part is in a piece whose forces can't be "
                                 "computed precisely enough");
    EXPECT_TRUE(report.falls());
}

TEST(StabilityReport, TellsPartsThatTipOverFromThoseThatAreNotHeld)
{
    StabilityReport report;
    report.stands = false;
    report.falling = {1, 2, 5};
    report.tipping = {1, 2};
    EXPECT_FALSE(report.tips());
    EXPECT_EQ(report.toString(), "the model falls: 2 parts tip over as a whole, since the centre of mass is not above "
                                 "the foot; 1 part is not held");
    report.falling = {5};
    report.tipping = {5};
    EXPECT_TRUE(report.tips());
    EXPECT_EQ(report.toString(), "the model falls: 1 part tips over as a whole, since the centre of mass is not above "
                                 "the foot");
}

TEST(StabilityReport, SaysThatAModelThatTipsEasilyDoesNotStandSafely)
{
    StabilityReport report;
    report.tippingAngle = 1.25;
    report.isMarginBound = true;
    report.safe = false;
    EXPECT_EQ(report.toString(),
              "the model stands, but not safely, with a margin of at least 100 %; on a table that tilts, it "
              "would tip as a whole at 1.2 degrees");
}

TEST(StabilityReport, AModelHoldsNoLargerTiltThanThatAtWhichItTips)
{
    StabilityReport report;
    report.tippingAngle = 19.4;
    report.tiltAngles = {20.2, 21.0, 20.2, 45.0};
    EXPECT_EQ(report.toString(), "the model stands safely, with a margin of 100 %; on a table that tilts, it would tip "
                                 "as a whole at 19.4 degrees; it stands on a base that is tilted by 19.4 degrees, but "
                                 "not more");
    report.isTiltBound = true;
    EXPECT_NE(report.toString().find("tilted by 19.4 degrees, but not more"), std::string::npos);
    report.tiltAngles = {18.0, 21.0, 20.2, 45.0};
    EXPECT_NE(report.toString().find("tilted by 18.0 degrees, or more"), std::string::npos);
}

TEST(StabilityReport, MarksAMarginThatIsABound)
{
    StabilityReport report;
    report.margin = 0.5;
    report.isMarginBound = true;
    EXPECT_EQ(report.toString(), "the model stands safely, with a margin of at least 50 %");
    report.safe = false;
    EXPECT_EQ(report.toString(), "the model stands, but maybe not safely, with a margin of at least 50 %");
}

} // namespace

} // namespace osgLego::test
