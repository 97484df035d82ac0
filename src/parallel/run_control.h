#pragma once

#include "parallel/checkpoint.h"

#include <cstdint>
#include <functional>

namespace multipath {

/// Called now and then with the number of lines done since the last call.
using LineCounter = std::function<void(std::uint64_t lines)>;

/// The part of the work that this run does of what several runs do together.
struct Shard
{
    std::uint64_t number = 0; ///< 0 ... of - 1
    std::uint64_t of = 1;

    /// This run does begin ... end - 1 of so many pieces; all shards together do each of them once.
    std::uint64_t begin(std::uint64_t pieces) const { return before(number, pieces); }
    std::uint64_t end(std::uint64_t pieces) const { return before(number + 1, pieces); }

private:
    /// pieces * n / of without overflow.
    std::uint64_t before(std::uint64_t n, std::uint64_t pieces) const { return pieces / of * n + pieces % of * n / of; }
};

/// How work is carried out; the result does not depend on it.
struct RunControl
{
    int threads = 1;
    LineCounter line_counter{};
    Checkpoint* checkpoint = nullptr; ///< empty: the work is done in one go
    Shard shard{};                    ///< of the stages whose results can be added; less than all needs a checkpoint

    void count_lines(std::uint64_t lines) const
    {
        if (line_counter)
            line_counter(lines);
    }
    bool stopped() const { return checkpoint && checkpoint->stopped(); }
    /// True for one of several shards.
    bool is_shard() const { return shard.of > 1; }
};

} // namespace multipath
