#pragma once

#include "geometry/hit.h"
#include "image/shading/patch_slopes.h"
#include "image/shading/visible_patches.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace multipath {

/// Continuous values over the surfaces of a scene, made from one value per patch. Patches share values at corners that
/// they have in common if they are of one material, without a crease between them, and nothing stands between them;
/// what furniture covers does not count. A linear ramp over a parallelogram is reproduced; sources keep the plain
/// values of their patches.
class SmoothShading
{
public:
    /// One value per patch; the scene and the values must outlive this object. `shown`: the surfaces that will be
    /// asked for, which saves time if they are few; all if it is empty.
    SmoothShading(const Scene& scene, const std::vector<Rgb>& values_per_patch, int threads,
                  const std::vector<char>& shown = {});

    /// The same of all surfaces, and how well the patches fit together: for each patch the square of what the values at
    /// its corners differ from its own linear function, as the mean over corners and channels, and a share of its bend
    /// (patch_slopes), times the share of the patch that is open. 0 for sources.
    SmoothShading(const Scene& scene, const std::vector<Rgb>& values_per_patch, int threads,
                  std::vector<double>& residuals);

    /// The value where a line meets a side that exists.
    Rgb at(const Hit& hit) const;

    /// The values at the corners of a patch, in the order of Scene::corners(); three of a triangle, then one unused.
    std::array<Rgb, 4> at_corners(std::uint32_t patch) const;

private:
    void find_corners(const VisiblePatches& patches, const std::vector<PatchSlope>& slopes, int threads,
                      const std::vector<char>& shown);

    const Scene& scene_;
    const std::vector<Rgb>& values_;
    std::vector<Rgb> corners_; ///< CornerLattice::per_cell for each patch
};

} // namespace multipath
