#include "radiosity/memory_estimate.h"

#include <algorithm>

namespace multipath {

namespace {

constexpr double bytes_per_surface = 700; // peak while the file is read: corners, mesh parts, names

} // namespace

double run_bytes(double surfaces, double patches)
{
    constexpr double bytes_per_patch = 400; // line counts, or shading, or a mesh for output
    return bytes_per_surface * surfaces + bytes_per_patch * patches;
}

double page_bytes(double surfaces, double patches)
{
    constexpr double bytes_per_patch = 600;
    return bytes_per_surface * surfaces + bytes_per_patch * patches;
}

double bytes_for_pairs(double memory, const Scene& scene)
{
    return std::max(0.0, memory - run_bytes(static_cast<double>(scene.surfaces().size()), scene.patch_count()));
}

} // namespace multipath
