#pragma once

#include "base/elementary.h"
#include "geometry/bounds.h"
#include "geometry/line.h"
#include "sampling/sequence.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace multipath {

/// How global lines are sampled. `sphere`: chords between two independent uniform points of the sphere around the
/// bounding box of the scene. `box`: lines from a uniform point of the surface of the bounding box, in a
/// cosine-distributed direction into the box.
enum class Chords { sphere, box };

/// Sampler of global lines. Both kinds of chords have the invariant density of integral geometry (Santalo 1976), which
/// is uniform in position and direction. All lines that start on the bounding box meet the box; of the chords of the
/// sphere only some do.
class GlobalLines
{
public:
    explicit GlobalLines(const Bounds& scene_box, Chords chords = Chords::sphere);

    /// The line of one 4-D item, a chord that begins before and ends after all surfaces along it.
    Line line(const Item& item) const;

    /// Writes the lines of `count` items to lines[0] ... lines[count - 1]: many at a time are computed faster.
    void lines(const Item* items, std::size_t count, Line* lines) const;

    /// Number of lines to cast so that `lines_met` of them meet the bounding box in expectation ((N1) in
    /// docs/equations.md), rounded to the nearest integer.
    std::uint64_t lines_to_cast(std::uint64_t lines_met) const;

    /// Expected number of crossings of a flat patch of `area` [m^2], from either side, by `lines_cast` lines ((G1) in
    /// docs/equations.md).
    double expected_crossings(double area, std::uint64_t lines_cast) const;

    /// [m^2] Area of the sphere around the bounding box, for both kinds of chords.
    double sphere_area() const { return 4.0 * pi * radius_ * radius_; }

private:
    /// A side of the box, spanned by two unit vectors whose cross product points into the box.
    struct Side
    {
        Vec3 corner;
        Vec3 along;
        Vec3 up;
        double width;     ///< [scene units] length of the side in direction `along`
        double height;    ///< [scene units] length of the side in direction `up`
        double strip_end; ///< [m^2] total area of this side and of those before it
    };

    static std::array<Side, 6> unrolled(const Bounds& box);
    Line box_line(const Item& item, Vec3 local) const;
    void sphere_lines(const Item* items, std::size_t count, Line* lines) const;
    void box_lines(const Item* items, std::size_t count, Line* lines) const;
    /// [m^2] Area of the surface on which the lines start, A_0 of (G1).
    double area_of_starts() const { return chords_ == Chords::box ? box_.area() : sphere_area(); }

    Bounds box_;
    Chords chords_;
    double radius_; ///< [scene units] radius of the sphere around the bounding box
    std::array<Side, 6> sides_;
};

} // namespace multipath
