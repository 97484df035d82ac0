#pragma once

#include "geometry/surface_table.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Continuous values over the surfaces of a scene, made from one value per patch. Each surface is interpolated from its
/// own patches; surfaces share values only at corners that they have in common, with one material and without a crease.
/// A linear ramp over a parallelogram is reproduced; sources keep the plain values of their patches.
class SmoothShading
{
public:
    /// One value per patch; the scene and the values must outlive this object.
    SmoothShading(const Scene& scene, const std::vector<Rgb>& values_per_patch);

    /// The value where a line meets a side that exists.
    Rgb at(const Hit& hit) const;

    /// The values at the corners of a patch, in the order of Scene::corners(); three of a triangle, then one unused.
    std::array<Rgb, 4> at_corners(std::uint32_t patch) const;

private:
    std::size_t first_corner(std::uint32_t surface, bool front) const;

    const Scene& scene_;
    const std::vector<Rgb>& values_;
    std::vector<std::size_t> first_corner_; ///< per surface, of its front; backs follow after all fronts
    std::vector<Rgb> corners_;              ///< of the patches, surface by surface
};

} // namespace multipath
