#include <osgLego/producer/MotionPace.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

TEST(MotionPace, ASourceMovesIfItsRequestsAreCloserThanThePause)
{
    MotionPace pace;
    EXPECT_FALSE(pace.request(0.0)) << "the first";
    EXPECT_TRUE(pace.request(0.1));
    EXPECT_TRUE(pace.request(0.1 + 0.9 * MotionPace::PAUSE));
    EXPECT_FALSE(pace.request(0.1 + 2.0 * MotionPace::PAUSE));
}

TEST(MotionPace, ASetIsFollowedByARestOfThreeTimesItsWork)
{
    MotionPace pace;
    EXPECT_EQ(pace.getRest(5.0), 0.0) << "before the first set";
    pace.end(0.01, 5.0);
    EXPECT_NEAR(pace.getRest(5.0), 0.03, 1e-9);
    EXPECT_NEAR(pace.getRest(5.02), 0.01, 1e-9);
    EXPECT_EQ(pace.getRest(5.04), 0.0);
}

TEST(MotionPace, NoRestIsLong)
{
    MotionPace pace;
    pace.end(60.0, 5.0);
    EXPECT_DOUBLE_EQ(pace.getRest(5.0), MotionPace::LONGEST_REST);
}

} // namespace

} // namespace osgLego::test
