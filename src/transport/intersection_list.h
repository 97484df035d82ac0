#pragma once

#include "geometry/intersector.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// A stretch of a line between two surfaces that follow each other along it, or from the last one to infinity.
/// `from` is the patch that the stretch leaves, `to` the patch that it reaches, each with the side that looks along
/// the stretch. One of the two may be `behind` (a surface that has no patch on this side) or `outside` (nothing).
struct Segment
{
    static constexpr std::uint32_t behind = 0xfffffffeu;
    static constexpr std::uint32_t outside = 0xffffffffu;

    std::uint32_t from;
    std::uint32_t to;

    static bool is_patch(std::uint32_t end) { return end < behind; }
    /// The facing pair of the paper: both ends can exchange power.
    bool joins_patches() const { return is_patch(from) && is_patch(to); }
};

/// What a line meets at one surface: the patch on the side where it arrives and the one on the side where it goes on,
/// or Segment::behind where the side has none.
struct Passage
{
    std::uint32_t arrives_at;
    std::uint32_t leaves;
};

Passage passage_at(const Scene& scene, const Hit& hit);

/// One passage for every hit of many lines, line after line. Replaces what `passages` held.
void find_passages(const Scene& scene, const HitLists& lists, std::vector<Passage>& passages);

/// Appends the segments of one line, given its hits in order. Those that touch no patch are left out.
void append_segments(const Scene& scene, HitLists::List hits, std::vector<Segment>& segments);

/// The segments of many lines, line after line. Replaces what `segments` held.
void find_segments(const Scene& scene, const HitLists& lists, std::vector<Segment>& segments);

} // namespace multipath
