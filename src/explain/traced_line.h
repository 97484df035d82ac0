#pragma once

#include "geometry/line.h"
#include "sampling/sequence.h"
#include "scene/rgb.h"
#include "transport/lines/line_segments.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// The number of a line in its stage, and the item of the sequence from which the line is made.
struct LineOrigin
{
    std::uint64_t number; ///< index of the line in the stage, from 0
    std::uint64_t item;   ///< index of the item in the sequence
    Item numbers;         ///< the four coordinates of the item
};

/// An intersection of a line with a surface.
struct Crossing
{
    Hit hit;
    Vec3 point;      ///< position of the hit [scene units]
    Passage patches; ///< the patches on the two sides of the surface
};

/// Power that a patch sends along a segment of a line. For a step of a gathering walk (W1): power that the patch where
/// the step ends contributes to the patch where the walk starts.
struct Transfer
{
    std::size_t segment; ///< index of the segment of the line
    std::uint32_t from;  ///< index of the patch that sends
    std::uint32_t to;    ///< index of the patch that receives, or Segment::behind or Segment::outside
    Rgb forecast;        ///< [W] (G3) on a global line, all the power on a line of transillumination, otherwise black
    Rgb held;            ///< [W] the rest of the sent power: on a global line what the sender held, else all or nothing
    Rgb counted;         ///< [W] incident power counted at `to`: the score of a particle, else all the power sent
    /// [W] What `to` holds afterwards: reflected power on a global line, unshot power on a ray of a first shot.
    /// Otherwise, or if no patch receives the power, black.
    Rgb then_held = {};

    Rgb sent() const { return forecast + held; }
};

/// What a line of a run does: a global line, a line of a bundle, a ray, or a path of rays (particle, walk).
struct TracedLine
{
    LineOrigin origin;               ///< of a path: item of its first ray
    std::vector<Vec3> points;        ///< [scene units] the polyline: start, hits, end, and where a path goes on
    std::vector<bool> joins;         ///< per segment of the polyline: true if it joins two patches
    std::vector<Crossing> crossings; ///< in order along the line
    std::vector<Transfer> transfers; ///< in the order in which they happen
    std::string opening; ///< where the line comes from; empty for a path, whose notes tell this and its hits
    /// What it carries, in sentences.
    std::vector<std::string> notes;
};

} // namespace multipath
