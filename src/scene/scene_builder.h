#pragma once

#include "scene/scene.h"

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace multipath {

/// Builds a scene in memory, without files. As in files, the front of a surface is the side from which its corners run
/// counter-clockwise; edge_u x edge_v points to that side.
class SceneBuilder
{
public:
    /// Adds a material and returns its index. `reflectance`: [1]; `emittance`: [W/m^2].
    std::uint32_t material(Rgb reflectance, Rgb emittance)
    {
        return material("material" + std::to_string(file_.materials.size()), reflectance, emittance);
    }
    std::uint32_t material(const std::string& name, Rgb reflectance, Rgb emittance)
    {
        file_.materials.push_back({name, reflectance, emittance, "memory"});
        return static_cast<std::uint32_t>(file_.materials.size() - 1);
    }
    /// A material with the same values in all channels.
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

    /// The walls_of_room() with a material each.
    SceneBuilder& room(Vec3 low, Vec3 high, const std::vector<std::uint32_t>& materials)
    {
        const std::array<Surface, 6> walls = walls_of_room(low, high - low);
        for (std::size_t k = 0; k < walls.size(); ++k)
            surface(walls[k], materials[k]);
        return *this;
    }
    SceneBuilder& room(Vec3 low, Vec3 high, std::uint32_t material)
    {
        return room(low, high, std::vector<std::uint32_t>(6, material));
    }

    /// The six faces of a box, facing outward, in the order of room().
    SceneBuilder& box(Vec3 low, Vec3 high, std::uint32_t material)
    {
        const std::size_t first = file_.surfaces.size();
        room(low, high, material);
        for (std::size_t s = first; s < file_.surfaces.size(); ++s)
            std::swap(file_.surfaces[s].edge_u, file_.surfaces[s].edge_v);
        return *this;
    }

    SceneBuilder& sun(const Sun& sun)
    {
        file_.sun = sun;
        return *this;
    }

    SceneFile file() const
    {
        SceneFile file = file_;
        file.path = "memory";
        file.groups = {""};
        return file;
    }
    /// `patch_size`: [scene units].
    Scene scene(double patch_size, bool two_sided = false) const { return Scene(file(), patch_size, two_sided); }

private:
    SceneFile file_;
};

} // namespace multipath
