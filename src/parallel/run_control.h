#pragma once

#include "parallel/checkpoint.h"

#include <cstdint>
#include <functional>

namespace multipath {

/// Progress callback, called now and then with the number of lines done since the last call: from any thread, but never
/// from two at once.
using LineCounter = std::function<void(std::uint64_t lines)>;

/// One shard, that is, one part of work that is split over several runs, usually on several computers.
struct Shard
{
    std::uint64_t number = 0; ///< index of this shard, 0 ... of - 1
    std::uint64_t of = 1;     ///< number of shards

    /// This shard does begin(units) ... end(units) - 1 of the units 0 ... units - 1, such as blocks of lines. All
    /// shards together do each unit once.
    std::uint64_t begin(std::uint64_t units) const { return before(number, units); }
    std::uint64_t end(std::uint64_t units) const { return before(number + 1, units); }

private:
    /// units * n / of without overflow.
    std::uint64_t before(std::uint64_t n, std::uint64_t units) const { return units / of * n + units % of * n / of; }
};

/// Settings of how work is carried out. The result does not depend on them, except that a shard does only its part.
struct RunControl
{
    int threads = 1;
    LineCounter line_counter{};       ///< empty: progress is not reported
    Checkpoint* checkpoint = nullptr; ///< null: the work runs without pauses
    Shard shard{};                    ///< for stages whose results can be added; several shards need a checkpoint

    void count_lines(std::uint64_t lines) const
    {
        if (line_counter)
            line_counter(lines);
    }
    /// True if the checkpoint has stopped the work.
    bool stopped() const { return checkpoint && checkpoint->stopped(); }
    /// True if the work is split over several shards.
    bool is_shard() const { return shard.of > 1; }
};

} // namespace multipath
