#pragma once

#include "sampling/random.h"
#include "scene/scene_builder.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace multipath {

/// A rotation about a random axis, a scale from 1e-3 to 1e3 and a shift of up to some scene sizes, all from one number.
class RigidMotion
{
public:
    explicit RigidMotion(std::uint64_t key)
    {
        std::uint64_t counter = 0;
        const auto within = [&](double low, double high) {
            return low + (high - low) * bits_to_unit(random_bits(key, counter++));
        };
        scale_ = std::pow(10.0, within(-3, 3));
        shift_ = scale_ * Vec3{within(-5, 5), within(-5, 5), within(-5, 5)};
        x_ = normalized({within(-1, 1), within(-1, 1), within(-1, 1)});
        y_ = normalized(cross(x_, {within(-1, 1), within(-1, 1), within(-1, 1)}));
        z_ = cross(x_, y_);
    }

    double scale() const { return scale_; }
    SceneFile moved(SceneFile file) const
    {
        for (Surface& surface : file.surfaces)
            surface = {surface.shape, turned(surface.origin) + shift_, turned(surface.edge_u), turned(surface.edge_v)};
        return file;
    }

private:
    Vec3 turned(Vec3 p) const { return scale_ * (p.x * x_ + p.y * y_ + p.z * z_); }

    double scale_;
    Vec3 shift_;
    Vec3 x_, y_, z_;
};

/// A closed room with a lamp for a ceiling; the three channels of its reflectances and emittance differ.
inline Scene coloured_room()
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.6, 0.0);
    const std::uint32_t red = builder.material({0.8, 0.2, 0.1}, {});
    const std::uint32_t lamp = builder.material({0.5, 0.5, 0.5}, {3.0, 2.0, 1.0});
    return builder.room({0, 0, 0}, {2, 1, 3}, {grey, lamp, red, grey, grey, red}).scene(0.5);
}

/// The second cell of every surface and each third one after it cut into four, of these two again, and one a third
/// time.
inline Scene unevenly_refined(const Scene& scene)
{
    std::vector<std::uint8_t> levels;
    for (std::uint32_t s = 0; s < scene.surfaces().size(); ++s)
        for (std::uint32_t cell = 0; cell < scene.tessellation(s).cell_count(); ++cell)
            if (cell % 3 == 1)
                levels.insert(levels.end(), {1, 2, 2, 2, 2, 1, 2, 2, 2, 3, 3, 3, 3});
            else
                levels.push_back(0);
    return scene.refined(levels);
}

} // namespace multipath
