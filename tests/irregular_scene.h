#pragma once

#include "scene/daylight.h"
#include "scene/scene_builder.h"
#include "scene/texture/texture.h"
#include "test_scenes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace multipath {

/// A scene in which no two things are equal, so that what takes one for another shows: slanted parallelograms and
/// triangles of different sizes, nowhere at 0; surfaces, materials, groups and lines numbered differently; two lamps,
/// sky and sun of different colours; a repeated and a clamped texture, neither square, each seen through slanted
/// frames.
inline SceneFile irregular_file()
{
    SceneBuilder builder;
    builder.material("unused", {0.31, 0.32, 0.33}, {});
    const std::uint32_t cloth = builder.material("cloth", {}, {});
    const std::uint32_t lamp = builder.material("lamp", {0.12, 0.07, 0.21}, {31, 17, 23});
    const std::uint32_t stone = builder.material("stone", {0.63, 0.45, 0.28}, {});
    const std::uint32_t screen = builder.material("screen", {}, {0.9, 0.4, 0.7});
    const std::uint32_t leaf = builder.material("leaf", {0.24, 0.58, 0.37}, {});
    builder.rectangle({0.3, 1.7, -2.9}, {0.3, 0.1, 2.6}, {3.4, 0.4, 0.5}, stone);   // floor, looks up
    builder.triangle({0.6, 2.0, -2.7}, {3.1, 2.3, -2.2}, {1.2, 4.1, -2.5}, leaf);   // looks along z
    builder.rectangle({3.5, 2.3, -2.1}, {0.2, 0.1, 1.9}, {0.2, 1.3, -0.1}, cloth);  // looks along -x
    builder.triangle({0.9, 2.6, -1.9}, {2.2, 2.4, -1.7}, {1.3, 2.9, -0.8}, screen); // looks down
    builder.rectangle({1.1, 3.8, -1.9}, {0.7, 0.1, 0.1}, {0.1, -0.1, 0.5}, lamp);   // looks down
    builder.triangle({2.6, 2.5, -1.4}, {2.7, 3.3, -1.3}, {2.5, 2.6, -0.5}, cloth);  // looks along x
    SceneFile file = builder.file();
    file.path = "irregular.obj";
    file.groups = {"ground", "tree", "", "lights", "flags"};
    file.group = {0, 1, 4, 2, 3, 4};
    file.line = {71, 64, 90, 83, 77, 101};
    file.textures = {std::make_shared<const Texture>("bars.ppm", "P3 1 2 255\n40 90 200\n250 60 20\n", false),
                     std::make_shared<const Texture>("tiles.pgm", "P2 3 2 255\n255 20 130\n90 240 60\n", true)};
    file.materials[cloth].texture = 1;
    file.materials[cloth].texture_scale = {0.9, 0.7, 0.5};
    file.materials[screen].texture = 0;
    file.materials[screen].texture_scale = {0.5, 0.8, 0.6};
    for (Material& material : file.materials)
        if (material.texture != Material::no_texture)
            material.reflectance = file.textures[material.texture]->mean() * material.texture_scale;
    file.texture_frames = {{},
                           {},
                           {{0.1, 0.2}, {2, 0.3}, {-0.2, 1.1}, true},
                           {{0.3, -0.2}, {0.4, 0.9}, {-0.5, 0.6}, true},
                           {},
                           {{7.2, -3.4}, {0.3, -1.2}, {1.7, 0.2}, true}};
    file.sun = sun_at(130.0, 50.0, {0, 1, 0}, {40, 30, 20});
    add_sky(file, {3, 2, 1});
    return file;
}

/// Its patches have different sizes even on one surface, and backs of their own.
inline Scene irregular_scene()
{
    return unevenly_refined(Scene(irregular_file(), 0.7, true));
}

/// Different numbers for all patches, channels and keys.
inline std::vector<Rgb> irregular_values(std::size_t count, std::uint64_t key)
{
    std::vector<Rgb> values;
    for (std::uint64_t k = 0; k < count; ++k) {
        const auto number = [&](std::uint64_t channel) {
            return 0.5 + bits_to_unit(random_bits(key, 3 * k + channel));
        };
        values.push_back({number(0), 2.0 * number(1), 3.0 * number(2)});
    }
    return values;
}

} // namespace multipath
