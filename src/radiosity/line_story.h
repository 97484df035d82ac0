#pragma once

// The stories: what single lines of a run do, for readers who want to follow the method step by step. They are made by
// the functions that the solver itself calls, in its order and with its items, so that what is told is what happens.

#include "sampling/sequence.h"
#include "transport/intersection_list.h"

#include <cstdint>

namespace multipath {

/// Which lines of a stage are told, counted from 0.
struct ToldRange
{
    std::uint64_t first = 0;
    std::uint64_t count = 3;

    bool includes(std::uint64_t number) const { return number >= first && number - first < count; }
};

/// What a line's numbers are: where it stands in its stage and in the sequence.
struct LineOrigin
{
    std::uint64_t number; ///< in its stage, from 0
    std::uint64_t item;   ///< of the sequence
    Item numbers;
};

/// A line and a surface, with the patches on its two sides.
struct Meeting
{
    Hit hit;
    Vec3 point;
    Passage patches;
};

Meeting meeting_at(const Scene& scene, const Line& line, const Hit& hit);

/// Throws SettingsError unless the stage has all these lines; `what` names them: "global lines".
void require_in_stage(const ToldRange& range, std::uint64_t lines, const char* what);

} // namespace multipath
