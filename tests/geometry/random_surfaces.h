#pragma once

#include "geometry/surface.h"
#include "sampling/random.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// A stream of random numbers for building test cases.
class Numbers
{
public:
    explicit Numbers(std::uint64_t key) : key_(key) {}
    double unit() { return bits_to_unit(random_bits(key_, counter_++)); }
    double within(double low, double high) { return low + (high - low) * unit(); }
    Vec3 point(double low, double high) { return {within(low, high), within(low, high), within(low, high)}; }
    std::size_t below(std::size_t end) { return static_cast<std::size_t>(unit() * static_cast<double>(end)); }

private:
    std::uint64_t key_;
    std::uint64_t counter_ = 0;
};

/// Unlike surfaces of both shapes, scattered through the unit cube, edges up to `size` in each coordinate.
inline SurfaceList scattered_surfaces(std::size_t count, double size, std::uint64_t key)
{
    Numbers numbers(key);
    SurfaceList surfaces;
    while (surfaces.size() < count) {
        const Shape shape = numbers.unit() < 0.5 ? Shape::triangle : Shape::parallelogram;
        const Surface surface = {shape, numbers.point(0, 1), numbers.point(-size, size), numbers.point(-size, size)};
        if (surface.area() > 0.01 * size * size)
            surfaces.push_back(surface);
    }
    return surfaces;
}

} // namespace multipath
