#pragma once

#include "geometry/vec3.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// True if a point of a piece of a surface lies under something that stands on it: no direction leads out. `shape`: the
/// piece, with its front where the point is to be seen from.
bool is_covered(const Scene& scene, std::uint32_t surface, const Surface& shape, Vec3 point);

/// The visible parts of the patches, without those on which furniture stands. The covered part of a patch is dark, so
/// that the value on its open part is larger than its mean. Of very many patches the small ones count as open, to save
/// time.
class VisiblePatches
{
public:
    /// One value per patch, of light that arrives from elsewhere; the scene and the values must outlive this object.
    VisiblePatches(const Scene& scene, const std::vector<Rgb>& values, int threads);

    const Scene& scene() const { return scene_; }

    /// [1] Share of the patch that nothing covers.
    double open_share(std::uint32_t patch) const;
    /// On the open part; that of the whole patch if there is none.
    Rgb value(std::uint32_t patch) const;
    /// The sampled point of the open part that is nearest to `corner`, if there is one.
    std::optional<Vec3> open_point_near(std::uint32_t patch, Vec3 corner) const;

private:
    std::uint32_t samples_along(std::uint32_t patch) const; ///< an edge of it

    const Scene& scene_;
    const std::vector<Rgb>& values_;
    double points_per_area_;          ///< [1/m^2] at most
    std::vector<std::uint64_t> open_; ///< per patch: a bit for each of its sampled points
};

} // namespace multipath
