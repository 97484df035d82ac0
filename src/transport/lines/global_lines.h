#pragma once

#include "geometry/bounds.h"
#include "geometry/line.h"
#include "sampling/sequence.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace multipath {

/// How global lines are sampled. `sphere`: chords between two independent uniform points of the sphere around the
/// scene's bounding box. `box`: lines from a uniform point of the surface of that box in a cosine-distributed direction
/// into it.
enum class Chords { sphere, box };

/// Sampler of global lines. Both kinds of chords have the invariant density of integral geometry [San76], which is
/// uniform in position and direction. All lines that start on the box meet it; of the chords of the sphere only some
/// do.
class GlobalLines
{
public:
    explicit GlobalLines(const Bounds& scene_box, Chords chords = Chords::sphere);

    /// The line of one 4-D item. It begins before and ends after all surfaces along it.
    Line line(const Item& item) const;

    /// Writes the lines of `count` items; the same lines, computed faster.
    void lines(const Item* items, std::size_t count, Line* lines) const;

    /// Number of lines to cast so that `lines_met` of them meet the scene's bounding box in expectation (N1).
    std::uint64_t lines_to_cast(std::uint64_t lines_met) const;

    /// Expected number of crossings of a flat patch of `area` [m^2], from either side, by `lines_cast` lines (G1).
    double expected_crossings(double area, std::uint64_t lines_cast) const;

    double sphere_area() const; ///< [m^2] of the sphere around the box

private:
    /// A side of the box, spanned by two unit vectors whose cross product points into the box.
    struct Side
    {
        Vec3 corner;
        Vec3 along;
        Vec3 up;
        double width;
        double height;
        double strip_end; ///< [m^2] cumulative area, this side included
    };

    static std::array<Side, 6> unrolled(const Bounds& box);
    Line sphere_line(const Item& item) const;
    Line box_line(const Item& item) const;
    Line box_line(const Item& item, Vec3 local) const;
    void sphere_lines(const Item* items, std::size_t count, Line* lines) const;
    void box_lines(const Item* items, std::size_t count, Line* lines) const;
    double area_of_starts() const; ///< [m^2] of the surface on which the lines start, A_0 of (G1)

    Bounds box_;
    Chords chords_;
    double radius_;
    std::array<Side, 6> sides_;
};

} // namespace multipath
