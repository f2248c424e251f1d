#include <osgLego/producer/BackgroundJob.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <pthread.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

using Job = BackgroundJob<int>;

/** Work that begins, and then waits until the test lets it go on. */
class HeldWork
{
public:
    /** @param result of the work. */
    Job::Work create(int result)
    {
        return [this, result](const Job::Run&, std::string&)
        {
            _hasBegun.set_value();
            _mayGoOn.get_future().wait();
            return result;
        };
    }
    void waitForBeginning() { _hasBegun.get_future().wait(); }
    /** May be called more than once. */
    void letGoOn()
    {
        if (!std::exchange(_isFree, true)) _mayGoOn.set_value();
    }

private:
    bool _isFree = false;
    std::promise<void> _hasBegun;
    std::promise<void> _mayGoOn;
};

/** A job that lists its delivered results and failures. */
class BackgroundJobTest : public testing::Test
{
protected:
    /** Failed tests end, too. */
    void TearDown() override
    {
        for (HeldWork* work : {&_first, &_second, &_third})
            work->letGoOn();
    }

    /** Request a run whose work returns its own revision. */
    Job::Request requestQuick(std::uint64_t revision)
    {
        const auto work = [revision](const Job::Run&, std::string&) { return static_cast<int>(revision); };
        return _job.request(revision, false, [&] { return work; });
    }

    /** Request a run whose work is held. */
    Job::Request requestHeld(std::uint64_t revision, HeldWork& work, bool waits = false)
    {
        return _job.request(revision, waits, [&] { return work.create(static_cast<int>(revision)); });
    }

    /** The reason why work fails. */
    std::string findFailure(std::uint64_t revision, const std::function<std::optional<int>(std::string& error)>& work)
    {
        const auto run = _job.request(revision, true,
                                      [&] { return [&](const Job::Run&, std::string& error) { return work(error); }; })
                             .run;
        run->wait();
        _job.deliver();
        EXPECT_EQ(run->getOutcome(), Job::Outcome::FAILED);
        EXPECT_EQ(run->getResult(), nullptr);
        return run->getFailure();
    }

    void expectCounts(std::size_t made, std::size_t failed, std::size_t cancelled)
    {
        const Job::Counts counts = _job.getCounts();
        EXPECT_EQ(counts.made, made);
        EXPECT_EQ(counts.failed, failed);
        EXPECT_EQ(counts.cancelled, cancelled);
    }

    std::atomic<int> _numAnnounced{0};
    std::vector<int> _results;
    std::vector<std::string> _failures;
    HeldWork _first;
    HeldWork _second;
    HeldWork _third;
    Job _job{{.outOfMemory = "no memory",
              .prefix = "because: ",
              .deliver = [this](int result) { _results.push_back(result); },
              .fail = [this](const std::string& failure) { _failures.push_back(failure); },
              .announce = [this] { ++_numAnnounced; }}};
};

TEST_F(BackgroundJobTest, AResultIsDeliveredOnce)
{
    _job.deliver();
    EXPECT_EQ(_job.getRun(), nullptr);
    const auto [run, isNew] = requestHeld(7, _first);
    EXPECT_TRUE(isNew);
    EXPECT_EQ(run->getRevision(), 7u);
    _job.deliver();
    EXPECT_EQ(run->getOutcome(), Job::Outcome::NONE);
    EXPECT_EQ(run->getResult(), nullptr);
    EXPECT_TRUE(_results.empty());
    _first.letGoOn();
    run->wait();
    EXPECT_EQ(run->getOutcome(), Job::Outcome::MADE);
    ASSERT_NE(run->getResult(), nullptr);
    EXPECT_EQ(*run->getResult(), 7);
    _job.deliver();
    _job.deliver();
    EXPECT_EQ(_results, std::vector<int>{7});
    expectCounts(1, 0, 0);
}

TEST_F(BackgroundJobTest, ARevisionHasOneRun)
{
    const auto [run, isNew] = requestQuick(7);
    const auto [same, isSameNew] = requestQuick(7);
    EXPECT_EQ(same, run);
    EXPECT_FALSE(isSameNew);
    run->wait();
    EXPECT_EQ(requestQuick(7).run, run);
    expectCounts(1, 0, 0);
}

TEST_F(BackgroundJobTest, AResultIsAnnouncedWhenItIsThere)
{
    std::promise<Job::Outcome> announced;
    std::shared_ptr<Job::Run> run;
    Job job({.announce = [&] { announced.set_value(run->getOutcome()); }});
    run = job.request(1, false, [&] { return _first.create(1); }).run;
    _first.letGoOn();
    EXPECT_EQ(announced.get_future().get(), Job::Outcome::MADE);
}

TEST_F(BackgroundJobTest, ExceptionsAndErrorsBecomeReasons)
{
    EXPECT_EQ(findFailure(1, [](std::string&) -> std::optional<int> { throw std::bad_alloc(); }), "no memory");
    EXPECT_EQ(findFailure(2, [](std::string&) -> std::optional<int> { throw std::length_error("x"); }), "no memory");
    EXPECT_EQ(findFailure(3, [](std::string&) -> std::optional<int> { throw std::runtime_error("x"); }), "because: x");
    const auto fail = [](std::string& error) -> std::optional<int>
    {
        error = "it is too large";
        return std::nullopt;
    };
    EXPECT_EQ(findFailure(4, fail), "it is too large");
    EXPECT_EQ(_failures, (std::vector<std::string>{"no memory", "no memory", "because: x", "it is too large"}));
    EXPECT_TRUE(_results.empty());
    EXPECT_EQ(_numAnnounced, 0);
    expectCounts(0, 4, 0);
    requestQuick(5).run->wait();
    _job.deliver();
    EXPECT_EQ(_results, std::vector<int>{5});
}

TEST_F(BackgroundJobTest, ACancelledRunHasNeitherAResultNorAFailure)
{
    const std::shared_ptr<Job::Run> run = requestHeld(1, _first).run;
    _first.waitForBeginning();
    _job.cancel();
    EXPECT_TRUE(run->isCancelled());
    EXPECT_EQ(_job.getRun(), nullptr);
    _first.letGoOn();
    run->wait();
    EXPECT_EQ(run->getOutcome(), Job::Outcome::CANCELLED);
    EXPECT_EQ(run->getResult(), nullptr);
    EXPECT_EQ(run->getFailure(), "");
    _job.deliver();
    EXPECT_TRUE(_results.empty());
    EXPECT_TRUE(_failures.empty());
    expectCounts(0, 0, 1);
    // The same revision may be requested again.
    requestQuick(1).run->wait();
    _job.deliver();
    EXPECT_EQ(_results, std::vector<int>{1});
    expectCounts(1, 0, 1);
}

TEST_F(BackgroundJobTest, ACancelledRunThatThrowsHasNotFailed)
{
    const auto work = [&](const Job::Run&, std::string&) -> std::optional<int>
    {
        _job.cancel();
        throw std::runtime_error("cancelled");
    };
    const std::shared_ptr<Job::Run> run = _job.request(1, false, [&] { return work; }).run;
    run->wait();
    EXPECT_EQ(run->getOutcome(), Job::Outcome::CANCELLED);
    EXPECT_EQ(run->getFailure(), "");
    expectCounts(0, 0, 1);
}

TEST_F(BackgroundJobTest, ANewerRequestCancelsTheRunInProgress)
{
    const std::shared_ptr<Job::Run> old = requestHeld(1, _first).run;
    _first.waitForBeginning();
    const std::shared_ptr<Job::Run> run = requestQuick(2).run;
    ASSERT_NE(run, nullptr);
    EXPECT_TRUE(old->isCancelled());
    EXPECT_FALSE(run->isCancelled());
    EXPECT_EQ(_job.getRun(), run);
    _first.letGoOn();
    old->wait();
    run->wait();
    _job.deliver();
    EXPECT_EQ(_results, std::vector<int>{2});
    expectCounts(1, 0, 1);
}

TEST_F(BackgroundJobTest, RequestsNeverCancelTwoRunsInARow)
{
    const std::shared_ptr<Job::Run> first = requestHeld(1, _first).run;
    _first.waitForBeginning();
    const std::shared_ptr<Job::Run> second = requestHeld(2, _second).run;
    EXPECT_TRUE(first->isCancelled());
    EXPECT_EQ(requestQuick(3).run, nullptr);
    EXPECT_FALSE(second->isCancelled());
    _first.letGoOn();
    _second.letGoOn();
    first->wait();
    second->wait();
    _job.deliver();
    EXPECT_EQ(_results, std::vector<int>{2});
    expectCounts(1, 0, 1);
}

TEST_F(BackgroundJobTest, ARunThatNoRequestWaitedForClearsTheWayForCancelling)
{
    requestHeld(1, _first);
    _first.waitForBeginning();
    requestQuick(2).run->wait();
    const std::shared_ptr<Job::Run> third = requestHeld(4, _third).run;
    EXPECT_EQ(_results, std::vector<int>{2}) << "delivered before it was replaced";
    _third.waitForBeginning();
    EXPECT_FALSE(_job.isRefusing());
    ASSERT_NE(requestQuick(5).run, nullptr);
    EXPECT_TRUE(third->isCancelled());
    _first.letGoOn();
    _third.letGoOn();
    third->wait();
    _job.getRun()->wait();
    _job.deliver();
    EXPECT_EQ(_results, (std::vector<int>{2, 5}));
}

TEST_F(BackgroundJobTest, ARequestThatHadToWaitIsNotCancelledInItsTurn)
{
    for (const bool isAsked : {false, true})
    {
        HeldWork first;
        HeldWork second;
        HeldWork third;
        Job job({});
        const auto request = [&](std::uint64_t revision, HeldWork& work)
        { return job.request(revision, false, [&] { return work.create(1); }).run; };
        request(1, first);
        const std::shared_ptr<Job::Run> kept = request(2, second);
        EXPECT_TRUE(isAsked ? job.isRefusing() : request(3, third) == nullptr);
        second.letGoOn();
        kept->wait();
        EXPECT_FALSE(job.isRefusing()) << "the run has ended";
        const std::shared_ptr<Job::Run> waited = request(3, third);
        ASSERT_NE(waited, nullptr);
        EXPECT_EQ(request(4, third), nullptr);
        EXPECT_FALSE(waited->isCancelled());
        first.letGoOn();
        third.letGoOn();
        waited->wait();
    }
}

TEST_F(BackgroundJobTest, RequestsThatWaitCancelAnyNumberOfRuns)
{
    const std::shared_ptr<Job::Run> first = requestHeld(1, _first, true).run;
    const std::shared_ptr<Job::Run> second = requestHeld(2, _second, true).run;
    const std::shared_ptr<Job::Run> third = requestHeld(3, _third, true).run;
    ASSERT_NE(third, nullptr);
    EXPECT_TRUE(first->isCancelled());
    EXPECT_TRUE(second->isCancelled());
    EXPECT_FALSE(third->isCancelled());
    _first.letGoOn();
    _second.letGoOn();
    _third.letGoOn();
    third->wait();
    EXPECT_EQ(*third->getResult(), 3);
}

TEST_F(BackgroundJobTest, CancellingEndsLoopsOfOneTbb)
{
    bool isEnding = false;
    const auto work = [&](const Job::Run& run, std::string&)
    {
        EXPECT_FALSE(oneapi::tbb::is_current_task_group_canceling());
        EXPECT_FALSE(run.isCancelled());
        _job.cancel();
        EXPECT_TRUE(run.isCancelled());
        isEnding = oneapi::tbb::is_current_task_group_canceling();
        return 1;
    };
    const std::shared_ptr<Job::Run> run = _job.request(1, false, [&] { return work; }).run;
    run->wait();
    EXPECT_TRUE(isEnding);
}

TEST_F(BackgroundJobTest, NoCallWaitsForAnAnnouncement)
{
    std::promise<void> mayReturn;
    std::atomic<int> numAnnounced{0};
    Job job({.announce = [&]
             {
                 if (++numAnnounced == 1) mayReturn.get_future().wait();
             }});
    const auto request = [&](std::uint64_t revision)
    {
        const auto work = [](const Job::Run&, std::string&) { return 1; };
        job.request(revision, true, [&] { return work; }).run->wait();
    };
    auto calls = std::async(std::launch::async,
                            [&]
                            {
                                request(1);
                                request(2);
                                job.deliver();
                                job.cancel();
                                job.deliver();
                            });
    const auto status = calls.wait_for(std::chrono::seconds(30));
    mayReturn.set_value();
    EXPECT_EQ(status, std::future_status::ready);
}

TEST_F(BackgroundJobTest, TheDestructorCancelsAndWaits)
{
    bool hasEnded = false;
    {
        Job job({});
        std::promise<void> hasBegun;
        const auto work = [&](const Job::Run& run, std::string&)
        {
            hasBegun.set_value();
            while (!run.isCancelled())
                std::this_thread::yield();
            hasEnded = true;
            return 1;
        };
        job.request(1, false, [&] { return work; });
        hasBegun.get_future().wait();
    }
    EXPECT_TRUE(hasEnded);
}

/** While it exists, no thread can be started: its stack would be larger than the address space. */
class NoThreads
{
public:
    NoThreads()
    {
        pthread_getattr_default_np(&_old);
        pthread_attr_t huge;
        pthread_attr_init(&huge);
        pthread_attr_setstacksize(&huge, std::size_t(1) << 50);
        pthread_setattr_default_np(&huge);
        pthread_attr_destroy(&huge);
    }
    ~NoThreads()
    {
        pthread_setattr_default_np(&_old);
        pthread_attr_destroy(&_old);
    }
    NoThreads(const NoThreads&) = delete;
    NoThreads& operator=(const NoThreads&) = delete;

private:
    pthread_attr_t _old;
};

TEST_F(BackgroundJobTest, IfNoThreadCanBeStartedTheCallerDoesTheWork)
{
    const NoThreads noThreads;
    ASSERT_THROW(std::thread([] {}).join(), std::system_error);
    std::thread::id worker;
    const auto work = [&](const Job::Run&, std::string&)
    {
        worker = std::this_thread::get_id();
        _job.cancel(); // needs the lock
        return 1;
    };
    const std::shared_ptr<Job::Run> cancelled = _job.request(1, false, [&] { return work; }).run;
    EXPECT_EQ(cancelled->getOutcome(), Job::Outcome::CANCELLED);
    EXPECT_EQ(worker, std::this_thread::get_id());
    const std::shared_ptr<Job::Run> run = requestQuick(2).run;
    EXPECT_EQ(run->getOutcome(), Job::Outcome::MADE);
    run->wait();
    _job.deliver();
    EXPECT_EQ(_results, std::vector<int>{2});
    EXPECT_EQ(_numAnnounced, 1);
}

} // namespace

} // namespace osgLego::test
