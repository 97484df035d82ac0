#pragma once

#include "test_scenes.h"

#include <vector>

namespace multipath {

/// A wall beside two walls, all cut into pieces of up to 1: 4 patches on the one side of the corner, 2 + 3 on the
/// other; and a triangle on top that is cut by its longest edge. A lamp far away.
inline SceneBuilder walls_that_do_not_match()
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    builder.rectangle({0, 0, 0}, {4, 0, 0}, {0, 3, 0}, paint);
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1.5, 0, 0}, paint);
    builder.rectangle({1.5, 0, 0}, {0, 0, 1}, {2.5, 0, 0}, builder.material({0.8, 0.1, 0.2}, {}));
    builder.triangle({0, 3, 0}, {4, 3, 0}, {2, 3, 5}, paint);
    builder.triangle({4, 3, 0}, {6, 3, 1}, {3.1, 3, 2.25}, paint);
    return builder.rectangle({0, 50, 0}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.5, 1.0));
}

/// Different values on all patches.
inline std::vector<Rgb> some_values(const Scene& scene)
{
    std::vector<Rgb> values;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        values.push_back({0.25 + 0.01 * (i * i % 37), 0.5 + 0.02 * (i * 7 % 11), 0.125 * (1 + i % 5)});
    return values;
}

} // namespace multipath
