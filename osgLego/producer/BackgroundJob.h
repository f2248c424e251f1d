#pragma once

#include <osgLego/producer/BackgroundTask.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace osgLego
{

/** Makes results on separate threads, each for one revision of its input, of which only the newest is wanted. A run may
 * offer a draft before its result.
 *
 * A request for another revision cancels the run in progress, though never twice in a row unless it demands so or the
 * run has offered a draft: input that changes faster than its results are made would otherwise never have one. If a
 * request had to wait for a run, the next run is not cancelled before its draft, either.
 *
 * Usage:
 *
 *     BackgroundJob<int> job({.deliver = [](int result) { use(result); }});
 *     job.request(1, false, [] { return [](auto& run, std::string&) { run.offer(41); return 42; }; });
 *     ... // in each frame:
 *     job.deliver();
 *
 * Every function may be called from any thread.
 */
template <typename Result>
class BackgroundJob
{
public:
    /** How a run has ended. */
    enum class Outcome
    {
        NONE, //!< it has not ended
        MADE,
        FAILED,
        CANCELLED
    };

    class Run;

    /** Makes a result, and returns early once the run is cancelled; may throw. @return nothing, with a sentence in
     * `error`, if it can't be made. */
    using Work = std::function<std::optional<Result>(Run& run, std::string& error)>;

    struct Options
    {
        std::string outOfMemory{}; //!< the reason if there is not enough memory
        std::string prefix{};      //!< comes before the reasons of other exceptions
        /** Called with a draft, and with a result that was made. Must not call the job. */
        std::function<void(const Result&)> deliver{};
        /** Called with the reason why a run has failed. Must not call the job. */
        std::function<void(const std::string&)> fail{};
        /** Called when a draft or a result has been made, in the thread that made it. */
        std::function<void()> announce{};
    };

    /** The number of runs that have ended. */
    struct Counts
    {
        std::size_t made = 0;
        std::size_t failed = 0;
        std::size_t cancelled = 0;
    };

    struct Request
    {
        std::shared_ptr<Run> run;
        bool isNew = false; //!< whether this request has started it
    };

    explicit BackgroundJob(Options options) : _options(std::move(options)) {}
    /** Cancels the runs in progress, and waits until they have ended. */
    ~BackgroundJob() = default;

    /** The run for a revision: the last one if it is for this revision, or a new one in its place.
     * @param isUrgent cancel a run in progress even if the one before it was cancelled, too.
     * @param createWork creates the work of a new run, after the last run has been delivered.
     * @return null if the run in progress is to end first. */
    Request request(std::uint64_t revision, bool isUrgent, const std::function<Work()>& createWork);
    /** Whether a request would have to wait for the run in progress unless it is urgent. Counts as such a request. */
    bool isRefusing();
    /** The last run that was requested; null if there is none, or if it was cancelled. */
    std::shared_ptr<Run> getRun() const;
    /** Whether a run is in progress or has not been delivered. */
    bool isBusy() const;
    /** Deliver the last run if it has ended, unless it has been delivered, or else its draft. */
    void deliver();
    /** Cancel the run in progress, without waiting for it to end. */
    void cancel();
    Counts getCounts() const;

private:
    bool lacksDraft() const;
    bool refuse();
    void deliverLast();
    void retire();
    void forgetEnded();

    Options _options;
    std::array<std::atomic<std::size_t>, 4> _numEnded{}; // for each outcome
    mutable std::mutex _mutex;
    bool _mustKeepLast = false; // whether the last run may only be cancelled by urgent requests, until it has a draft
    bool _hasRefused = false;   // whether a request has been refused because of the last run
    bool _isDelivered = false;
    std::shared_ptr<Run> _last;
    std::vector<std::shared_ptr<Run>> _retired; // cancelled, but possibly not ended
};

/** One run of a job, which it must not outlive. Every function may be called from any thread. */
template <typename Result>
class BackgroundJob<Result>::Run
{
public:
    Run(BackgroundJob& job, std::uint64_t revision, Work work) :
        _job(job), _revision(revision), _work(std::move(work)),
        _task({.work = [this] { _result = _work(*this, _failure); },
               .outOfMemory = job._options.outOfMemory,
               .prefix = job._options.prefix,
               .settle = [this](std::string&& failure) { settle(std::move(failure)); },
               .announce = [this] { announce(); }})
    {
    }

    std::uint64_t getRevision() const { return _revision; }
    /** Wait until the run has ended, or for a number of seconds. */
    void wait(double seconds = BackgroundTask::FOREVER) const { _task.wait(seconds); }
    /** The same, but also end the wait when there is a draft. */
    void waitForDraft(double seconds) const
    {
        _task.wait(seconds, [this] { return hasDraft(); });
    }
    /** Whether a draft has been offered. */
    bool hasDraft() const { return _hasDraft; }
    bool isCancelled() const { return _task.isCancelled(); }
    Outcome getOutcome() const { return _task.hasEnded() ? _outcome : Outcome::NONE; }
    /** Null unless the outcome is MADE. */
    const Result* getResult() const { return getOutcome() == Outcome::MADE ? &*_result : nullptr; }
    /** The reason if the outcome is FAILED; otherwise empty. */
    std::string getFailure() const { return getOutcome() == Outcome::FAILED ? _failure : std::string(); }

    // These functions are for the work.
    /** Have the job deliver a draft. Called at most once. */
    void offer(Result draft)
    {
        {
            const std::lock_guard lock(_draftMutex);
            _draft = std::move(draft);
        }
        _hasDraft = true;
        _task.wake();
        if (_job._options.announce && !isCancelled()) _job._options.announce();
    }
    /** Sleep for a number of seconds: less if the run is cancelled, or if another thread waits for it. */
    void rest(double seconds) const { _task.rest(seconds); }

private:
    friend class BackgroundJob;

    /** The draft, unless it has been taken. */
    std::optional<Result> takeDraft()
    {
        const std::lock_guard lock(_draftMutex);
        return std::exchange(_draft, std::nullopt);
    }

    void settle(std::string&& failure)
    {
        _work = nullptr; // and all that it holds
        if (!failure.empty()) _failure = std::move(failure);
        _outcome = _result ? Outcome::MADE : Outcome::FAILED;
        if (_task.isCancelled())
        {
            _outcome = Outcome::CANCELLED;
            _result.reset();
        }
        ++_job._numEnded[static_cast<std::size_t>(_outcome)];
    }

    void announce()
    {
        if (_outcome == Outcome::MADE && _job._options.announce) _job._options.announce();
    }

    BackgroundJob& _job;
    std::uint64_t _revision;
    Work _work;
    std::mutex _draftMutex;
    std::optional<Result> _draft; // not yet taken
    std::atomic<bool> _hasDraft{false};
    std::optional<Result> _result;
    std::string _failure;
    Outcome _outcome = Outcome::NONE;
    BackgroundTask _task; // last, so that it has ended before the other members are destroyed
};

template <typename Result>
typename BackgroundJob<Result>::Request BackgroundJob<Result>::request(std::uint64_t revision, bool isUrgent,
                                                                       const std::function<Work()>& createWork)
{
    std::shared_ptr<Run> run;
    {
        const std::lock_guard lock(_mutex);
        if (_last && _last->getRevision() == revision) return {_last, false};
        if (!isUrgent && refuse()) return {};
        _mustKeepLast = std::exchange(_hasRefused, false) || lacksDraft();
        deliverLast();
        retire();
        run = _last = std::make_shared<Run>(*this, revision, createWork());
        _isDelivered = false;
    }
    run->_task.start(); // without the lock, since this thread may do the work
    return {run, true};
}

template <typename Result>
bool BackgroundJob<Result>::isRefusing()
{
    const std::lock_guard lock(_mutex);
    return refuse();
}

/** Whether a run is in progress without even a draft. */
template <typename Result>
bool BackgroundJob<Result>::lacksDraft() const
{
    return _last && _last->getOutcome() == Outcome::NONE && !_last->hasDraft();
}

/** @return whether a request has to wait. */
template <typename Result>
bool BackgroundJob<Result>::refuse()
{
    const bool refuses = _mustKeepLast && lacksDraft();
    if (refuses) _hasRefused = true;
    return refuses;
}

template <typename Result>
std::shared_ptr<typename BackgroundJob<Result>::Run> BackgroundJob<Result>::getRun() const
{
    const std::lock_guard lock(_mutex);
    return _last;
}

template <typename Result>
bool BackgroundJob<Result>::isBusy() const
{
    const std::lock_guard lock(_mutex);
    return _last && !_isDelivered;
}

template <typename Result>
void BackgroundJob<Result>::deliver()
{
    const std::lock_guard lock(_mutex);
    deliverLast();
    forgetEnded();
}

template <typename Result>
void BackgroundJob<Result>::cancel()
{
    const std::lock_guard lock(_mutex);
    retire();
}

template <typename Result>
typename BackgroundJob<Result>::Counts BackgroundJob<Result>::getCounts() const
{
    const auto count = [this](Outcome outcome) { return _numEnded[static_cast<std::size_t>(outcome)].load(); };
    return {count(Outcome::MADE), count(Outcome::FAILED), count(Outcome::CANCELLED)};
}

template <typename Result>
void BackgroundJob<Result>::deliverLast()
{
    if (!_last || _isDelivered) return;
    const Outcome outcome = _last->getOutcome();
    const std::optional<Result> draft = _last->takeDraft();
    _isDelivered = outcome == Outcome::MADE || outcome == Outcome::FAILED;
    if (const Result* result = outcome == Outcome::MADE ? _last->getResult() : draft ? &*draft : nullptr)
        if (_options.deliver) _options.deliver(*result);
    if (outcome == Outcome::FAILED && _options.fail) _options.fail(_last->getFailure());
}

/** Cancel the last run, without waiting for it to end. */
template <typename Result>
void BackgroundJob<Result>::retire()
{
    forgetEnded();
    if (!_last) return;
    _retired.push_back(_last); // first: if there is no memory for it, the last run goes on
    _last->_task.cancel();
    _last.reset();
}

/** Destroy the retired runs whose threads have nothing left to do, so that no lock is held while waiting for a thread.
 */
template <typename Result>
void BackgroundJob<Result>::forgetEnded()
{
    std::erase_if(_retired, [](const std::shared_ptr<Run>& run) { return run->_task.hasReturned(); });
}

} // namespace osgLego
