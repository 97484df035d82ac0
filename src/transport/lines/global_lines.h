#pragma once

#include "geometry/bounds.h"
#include "geometry/line.h"
#include "sampling/sequence.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace multipath {

/// Where global lines come from: two independent uniform points of the sphere around the scene's bounding box, or a
/// uniform point of that box and a cosine-distributed direction into it.
enum class Chords { sphere, box };

/// Global lines. Both kinds have the invariant density of integral geometry [San76], the same everywhere and in every
/// direction; every line of the box meets it, of the sphere's only some do.
class GlobalLines
{
public:
    explicit GlobalLines(const Bounds& scene_box, Chords chords = Chords::sphere);

    Line line(const Item& item) const;

    /// The same lines for many items, faster.
    void lines(const Item* items, std::size_t count, Line* lines) const;

    /// How many chords to cast so that `lines_met` of them meet the scene's bounding box in expectation (N1).
    std::uint64_t lines_to_cast(std::uint64_t lines_met) const;

    /// Expected number of crossings of a flat patch of this area [m^2] by so many cast lines, both directions (G1).
    double expected_crossings(double area, std::uint64_t lines_cast) const;

    double sphere_area() const; ///< [m^2]

private:
    /// A side of the box, spanned by two unit vectors.
    struct Side
    {
        Vec3 corner;
        Vec3 along;
        Vec3 up;
        double width;
        double height;
        double strip_end; ///< [m^2] area of the sides up to this one
    };

    static std::array<Side, 6> unrolled(const Bounds& box);
    Line sphere_line(const Item& item) const;
    Line box_line(const Item& item) const;
    Line box_line(const Item& item, Vec3 local) const;
    void sphere_lines(const Item* items, std::size_t count, Line* lines) const;
    void box_lines(const Item* items, std::size_t count, Line* lines) const;
    double area_of_starts() const; ///< [m^2]

    Bounds box_;
    Chords chords_;
    double radius_;
    std::array<Side, 6> sides_;
};

} // namespace multipath
