#pragma once

#include "geometry/surface.h"

#include <array>
#include <cstddef>

namespace multipath {

/// The corners of a surface in its coordinates (u, v), counter-clockwise seen from the front.
struct SquareCorners
{
    std::array<std::array<double, 2>, 4> uv;
    std::size_t count;

    const std::array<double, 2>* begin() const { return uv.data(); }
    const std::array<double, 2>* end() const { return uv.data() + count; }
};

inline const SquareCorners& square_corners(Shape shape)
{
    static constexpr SquareCorners triangle = {{{{0, 0}, {1, 0}, {0, 1}, {0, 0}}}, 3};
    static constexpr SquareCorners parallelogram = {{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, 4};
    return shape == Shape::triangle ? triangle : parallelogram;
}

} // namespace multipath
