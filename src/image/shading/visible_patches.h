#pragma once

#include "geometry/vec3.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// True if a point of `surface` is covered by something that stands on it: each of five test rays from the point, in
/// different directions, ends within a rounding error of the point or, in a one-sided scene, at the back of a surface
/// (inside a solid). `shape`: the surface or a part of it, with its front on the side to be tested.
bool is_covered(const Scene& scene, std::uint32_t surface, const Surface& shape, Vec3 point);

/// The uncovered ("open") parts of the patches. The part of a patch on which furniture stands is dark, so that the
/// value on the open part is larger than the mean over the patch. Coverage is sampled with 64 points on
/// patches that touch another surface, and with one on others, which are open or covered as a whole. Where very many
/// touch, small ones get fewer points, and the smallest count as open, to save time.
class VisiblePatches
{
public:
    /// `values`: one per patch, the mean over the patch, to which covered parts contribute 0. The scene and the values
    /// must outlive this object.
    VisiblePatches(const Scene& scene, const std::vector<Rgb>& values, int threads);

    const Scene& scene() const { return scene_; }

    /// [1] Share of the patch that nothing covers.
    double open_share(std::uint32_t patch) const;
    /// Value on the open part: the value of the patch divided by its open share. A patch that is a source or entirely
    /// covered keeps its value.
    Rgb value(std::uint32_t patch) const;
    /// Of the open sample points of the patch, the one nearest to `corner`. std::nullopt if the patch is entirely
    /// covered.
    std::optional<Vec3> open_point_near(std::uint32_t patch, Vec3 corner) const;

    /// True if no occluder, such as a wall, separates the open parts of two patches of one side at the middle between
    /// their centres. False if one of them is entirely covered.
    bool are_joined(std::uint32_t a, std::uint32_t b) const;

private:
    const Scene& scene_;
    const std::vector<Rgb>& values_;
    std::vector<std::uint8_t> along_; ///< per patch: number of sample points along an edge: 1, 2, 4 or 8
    std::vector<std::uint64_t> open_; ///< per patch: one bit per sample point, set if it is open
};

} // namespace multipath
