// To be preloaded: a program can start only as many threads at once as the variable MOST_THREADS says, as under a limit
// of processes, which has no effect on root and counts the other processes of a user.

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <memory>

#include <dlfcn.h>
#include <pthread.h>

namespace
{

using Run = void* (*)(void*);
using Create = int (*)(pthread_t*, const pthread_attr_t*, Run, void*);

std::atomic<int> numAlive{0};

struct Start
{
    Run run;
    void* argument;
};

void* runCounted(void* given)
{
    const std::unique_ptr<Start> start(static_cast<Start*>(given));
    void* result = start->run(start->argument);
    --numAlive;
    return result;
}

} // namespace

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, Run run, void* argument)
{
    static const auto create = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
    const char* most = std::getenv("MOST_THREADS");
    if (++numAlive > (most ? std::atoi(most) : 0))
    {
        --numAlive;
        return EAGAIN;
    }
    auto start = std::make_unique<Start>(Start{run, argument});
    const int failure = create(thread, attributes, runCounted, start.get());
    if (failure == 0)
        (void)start.release();
    else
        --numAlive;
    return failure;
}
