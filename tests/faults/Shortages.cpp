#include "Shortages.h"

#include <cstddef>
#include <cstring>
#include <new>
#include <vector>

#include <oneapi/tbb/global_control.h>
#include <osg/Notify>
#include <osg/ref_ptr>

namespace osgLego::test
{

namespace
{

/** Keeps printed messages without operator new. */
class Messages : public osg::NotifyHandler
{
public:
    Messages() { _text.reserve(1 << 16); }

    void notify(osg::NotifySeverity, const char* message) override
    {
        if (_text.size() + std::strlen(message) < _text.capacity()) _text += message;
    }

    std::string take() { return std::string(_text) + (_text.clear(), ""); }

private:
    std::string _text;
};

/** How work has ended. */
struct Ending
{
    bool hasThrown = false;
    std::string result;
    std::string message;
};

/** Runs work without faults, and then with each of its allocations that has a call stack of its own failing. */
class Shortage
{
public:
    Shortage(const Work& work, MemoryFaults::Extent extent) : _work(work), _extent(extent)
    {
        osg::setNotifyHandler(_messages);
    }

    ~Shortage() { osg::setNotifyHandler(new osg::StandardNotifyHandler); }
    Shortage(const Shortage&) = delete;
    Shortage& operator=(const Shortage&) = delete;

    /** Let the work fail everywhere. @return the number of failures. */
    std::size_t failEverywhere()
    {
        const std::string expected = run().result;
        EXPECT_FALSE(expected.empty());
        _work.prepare();
        MemoryFaults::record();
        _work.work();
        const std::vector<std::size_t> calls = MemoryFaults::getRecorded();
        run(); // so that its result is among the blocks
        for (const std::size_t call : calls)
        {
            EXPECT_FALSE(leaks(call, expected)) << "call " << call;
            if (::testing::Test::HasFailure()) break;
        }
        return calls.size();
    }

private:
    /** Let a call fail, and then work without faults. @return whether blocks are lost each time, rather than kept, such
     * as the capacity of a text, or not freed yet by another thread. */
    bool leaks(std::size_t call, const std::string& expected)
    {
        constexpr int MOST = 100;
        const std::size_t numBlocks = MemoryFaults::getNumBlocks();
        for (std::size_t times = 1; times <= MOST; ++times)
        {
            fail(call, expected);
            EXPECT_EQ(run().result, expected) << "after call " << call << " has failed";
            if (::testing::Test::HasFailure() || MemoryFaults::getNumBlocks() < numBlocks + times) return false;
        }
        return true;
    }

    Ending run()
    {
        return end([this] { _work.work(); });
    }

    Ending end(const std::function<void()>& call)
    {
        _work.prepare();
        _messages->take();
        Ending ending;
        try
        {
            call();
        }
        catch (const std::bad_alloc&)
        {
            ending.hasThrown = true;
        }
        MemoryFaults::end();
        if (!ending.hasThrown) ending.result = _work.getResult();
        ending.message = _messages->take() + _work.getMessage();
        return ending;
    }

    void fail(std::size_t call, const std::string& expected)
    {
        const Ending ending = end(
            [&]
            {
                MemoryFaults::begin(call, _extent);
                _work.work();
            });
        // Without any memory, there is none for a message either.
        const bool mayThrow = _work.mayThrow || _extent == MemoryFaults::Extent::ALL_AFTER;
        EXPECT_TRUE(mayThrow || !ending.hasThrown) << "call " << call;
        if (ending.hasThrown) return;
        if (ending.result.empty())
            EXPECT_NE(ending.message.find("memory"), std::string::npos) << "call " << call << ": " << ending.message;
        else
            EXPECT_EQ(ending.result, expected) << "call " << call << ": " << ending.message;
    }

    const Work& _work;
    MemoryFaults::Extent _extent;
    osg::ref_ptr<Messages> _messages = new Messages;
};

} // namespace

std::string nameOf(const ::testing::TestParamInfo<Scarcity>& scarcity)
{
    const auto [extent, numThreads] = scarcity.param;
    const std::string name = extent == MemoryFaults::Extent::ONE ? "OneFails" : "AllFail";
    return name + (numThreads == 1 ? "InAThread" : "InTwoThreads");
}

void surviveShortages(const Work& work, const Scarcity& scarcity)
{
    const auto [extent, numThreads] = scarcity;
    const oneapi::tbb::global_control control(oneapi::tbb::global_control::max_allowed_parallelism,
                                              static_cast<std::size_t>(numThreads));
    const std::size_t numFailures = Shortage(work, extent).failEverywhere();
    ::testing::Test::RecordProperty("failures", std::to_string(numFailures));
}

} // namespace osgLego::test
