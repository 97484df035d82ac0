#pragma once

#include "geometry/bounds.h"
#include "geometry/line.h"
#include "sampling/sequence.h"

#include <cstdint>

namespace multipath {

/// Global lines: chords between two independent uniform points of the sphere around the scene's bounding box. Their
/// density is the invariant one of integral geometry [San76]: the same everywhere and in every direction.
class GlobalLines
{
public:
    explicit GlobalLines(const Bounds& scene_box);

    Line line(const Item& item) const;

    /// How many chords to cast so that `lines_met` of them meet the scene's bounding box in expectation (N1).
    std::uint64_t lines_to_cast(std::uint64_t lines_met) const;

    /// Expected number of crossings of a flat patch of this area [m^2] by so many cast lines, both directions (G1).
    double expected_crossings(double area, std::uint64_t lines_cast) const;

    double sphere_area() const; ///< [m^2]

private:
    Vec3 centre_;
    double radius_;
    double box_area_;
};

} // namespace multipath
