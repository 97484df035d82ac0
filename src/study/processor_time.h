#pragma once

#include <ctime>

namespace multipath {

/// The processor time that the calling thread has taken since this object was made: unlike the clock on the wall, it
/// does not run while other programs do.
class ProcessorTime
{
public:
    double seconds() const { return now() - start_; } ///< [s]

private:
    static double now()
    {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    double start_ = now();
};

} // namespace multipath
