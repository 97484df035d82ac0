#pragma once

#include "sampling/random.h"
#include "scene/scene.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace multipath {

/// Scenes put together in a test, without files.
class SceneBuilder
{
public:
    /// Number of a new material.
    std::uint32_t material(Rgb reflectance, Rgb emittance)
    {
        file_.materials.push_back(
            {"material" + std::to_string(file_.materials.size()), reflectance, emittance, "test"});
        return static_cast<std::uint32_t>(file_.materials.size() - 1);
    }
    std::uint32_t grey(double reflectance, double emittance)
    {
        return material({reflectance, reflectance, reflectance}, {emittance, emittance, emittance});
    }

    SceneBuilder& surface(const Surface& surface, std::uint32_t material)
    {
        file_.surfaces.push_back(surface);
        file_.material.push_back(material);
        file_.group.push_back(0);
        file_.line.push_back(static_cast<std::uint32_t>(file_.line.size() + 1));
        return *this;
    }
    SceneBuilder& rectangle(Vec3 corner, Vec3 edge_u, Vec3 edge_v, std::uint32_t material)
    {
        return surface({Shape::parallelogram, corner, edge_u, edge_v}, material);
    }
    SceneBuilder& triangle(Vec3 a, Vec3 b, Vec3 c, std::uint32_t material)
    {
        return surface({Shape::triangle, a, b - a, c - a}, material);
    }

    /// The six walls of a room seen from inside: floor, ceiling (y), then x low, x high, z low, z high.
    SceneBuilder& room(Vec3 low, Vec3 high, const std::vector<std::uint32_t>& materials)
    {
        const Vec3 d = high - low;
        const Vec3 x = {d.x, 0, 0};
        const Vec3 y = {0, d.y, 0};
        const Vec3 z = {0, 0, d.z};
        rectangle(low, z, x, materials[0]);
        rectangle(low + y, x, z, materials[1]);
        rectangle(low, y, z, materials[2]);
        rectangle(low + x, z, y, materials[3]);
        rectangle(low, x, y, materials[4]);
        return rectangle(low + z, y, x, materials[5]);
    }
    SceneBuilder& room(Vec3 low, Vec3 high, std::uint32_t material)
    {
        return room(low, high, std::vector<std::uint32_t>(6, material));
    }

    /// The six faces of a box seen from outside, in the order of room().
    SceneBuilder& box(Vec3 low, Vec3 high, std::uint32_t material)
    {
        const std::size_t first = file_.surfaces.size();
        room(low, high, material);
        for (std::size_t s = first; s < file_.surfaces.size(); ++s)
            std::swap(file_.surfaces[s].edge_u, file_.surfaces[s].edge_v);
        return *this;
    }

    SceneFile file() const
    {
        SceneFile file = file_;
        file.path = "test";
        file.groups = {""};
        return file;
    }
    Scene scene(double patch_size, bool two_sided = false) const { return Scene(file(), patch_size, two_sided); }

private:
    SceneFile file_;
};

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

} // namespace multipath
