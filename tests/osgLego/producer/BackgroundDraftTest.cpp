#include <osgLego/producer/BackgroundJob.h>

#include <atomic>
#include <cstdint>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** A job that lists its delivered drafts and results. */
class BackgroundDraftTest : public testing::Test
{
protected:
    using Job = BackgroundJob<int>;

    std::atomic<int> _numAnnounced{0};
    std::promise<std::size_t> _announced; // the number of results at the first announcement
    std::vector<int> _results;
    Job _job{{.deliver = [this](int result) { _results.push_back(result); },
              .announce =
                  [this]
              {
                  if (++_numAnnounced == 1) _announced.set_value(_job.getCounts().made);
              }}};
};

TEST_F(BackgroundDraftTest, ADraftIsDeliveredBeforeTheResult)
{
    std::promise<void> mayGoOn;
    const auto work = [&](Job::Run& run, std::string&)
    {
        run.offer(6);
        mayGoOn.get_future().wait();
        return 7;
    };
    const std::shared_ptr<Job::Run> run = _job.request(1, false, [&] { return work; }).run;
    run->waitForDraft(BackgroundTask::FOREVER);
    EXPECT_TRUE(run->hasDraft());
    EXPECT_EQ(run->getOutcome(), Job::Outcome::NONE);
    _job.deliver();
    _job.deliver();
    EXPECT_EQ(_results, std::vector<int>{6});
    EXPECT_TRUE(_job.isBusy()) << "the result is missing";
    mayGoOn.set_value();
    run->wait();
    _job.deliver();
    EXPECT_EQ(_results, (std::vector<int>{6, 7}));
    EXPECT_FALSE(_job.isBusy());
    EXPECT_EQ(_job.getCounts().made, 1u);
    EXPECT_EQ(_announced.get_future().get(), 0u) << "the draft was announced first";
}

TEST_F(BackgroundDraftTest, ADraftIsNotDeliveredAfterItsResult)
{
    const auto work = [](Job::Run& run, std::string&)
    {
        run.offer(6);
        return 7;
    };
    const std::shared_ptr<Job::Run> run = _job.request(1, false, [&] { return work; }).run;
    run->wait();
    run->waitForDraft(BackgroundTask::FOREVER);
    _job.deliver();
    EXPECT_EQ(_results, std::vector<int>{7});
}

TEST_F(BackgroundDraftTest, RunsThatHaveADraftAreCancelledEvenInARow)
{
    for (int revision = 1; revision <= 4; ++revision)
    {
        const auto work = [revision](Job::Run& run, std::string&)
        {
            run.offer(revision);
            while (!run.isCancelled())
                std::this_thread::yield();
            return revision;
        };
        const std::shared_ptr<Job::Run> run =
            _job.request(static_cast<std::uint64_t>(revision), false, [&] { return work; }).run;
        ASSERT_NE(run, nullptr) << revision;
        run->waitForDraft(BackgroundTask::FOREVER);
    }
    EXPECT_EQ(_results, (std::vector<int>{1, 2, 3})) << "delivered before their runs were replaced";
    _job.cancel();
}

TEST_F(BackgroundDraftTest, ARestEndsWhenAThreadWaits)
{
    const auto work = [](Job::Run& run, std::string&)
    {
        run.rest(1e5);
        return run.isCancelled() ? 0 : 7;
    };
    const std::shared_ptr<Job::Run> run = _job.request(1, false, [&] { return work; }).run;
    run->wait();
    ASSERT_NE(run->getResult(), nullptr);
    EXPECT_EQ(*run->getResult(), 7);
}

TEST_F(BackgroundDraftTest, ARestEndsWhenItsRunIsCancelled)
{
    std::promise<void> hasEnded;
    std::promise<void> hasBegun;
    const auto work = [&](Job::Run& run, std::string&)
    {
        hasBegun.set_value();
        run.rest(1e5);
        hasEnded.set_value();
        return 7;
    };
    _job.request(1, false, [&] { return work; });
    hasBegun.get_future().wait();
    _job.cancel();
    hasEnded.get_future().wait();
    EXPECT_EQ(_job.getRun(), nullptr);
}

} // namespace

} // namespace osgLego::test
