#pragma once

#include "parallel/blocks.h"
#include "parallel/run_control.h"
#include "radiosity/reuse/light_tree.h"
#include "sampling/allotment.h"
#include "sampling/sequence.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstdint>
#include <future>
#include <vector>

namespace multipath {

/// Trees over the lights (emitting surfaces) and over the patches of a scene, and the light cut of every patch
/// (LightCuts). They are the same for all runs, and are built on first use, on `threads` threads. Safe to share between
/// threads; the scene must outlive this object.
struct SceneLights
{
    SceneLights(const Scene& scene, int threads);

    int threads; ///< on which they are built
    std::shared_future<LightTree> tree;
    std::shared_future<LightCuts> cuts;
    std::shared_future<SurfaceTree> patches;
};

/// Sums over the shadow rays of a patch. For each ray, g is the light that it would carry without obstacles, divided by
/// the light that the approximate irradiance of its cluster (SeenCluster) assumes; v is 1 if nothing blocks the ray,
/// else 0.
struct ShadowRaySums
{
    double rays = 0.0;   ///< number of rays
    double kernel = 0.0; ///< sum of g
    double error = 0.0;  ///< sum of g - 1 over the rays to clusters of several lights, whose irradiance is approximate
    double square = 0.0; ///< sum of (g - 1)^2 over the same rays
    double free = 0.0;   ///< number of unblocked rays
    Rgb light;           ///< sum of g v c, where c is the emittance of the light divided by the mean of its channels
};

/// Direct light, gathered by shadow rays from the patches. Each patch casts rays to its lights in proportion to the
/// irradiance that they would cause without obstacles, H0 in total. The estimated irradiance of the patch is
///
///   H0 (1 + e) sum of g v c / sum of g        ((R5) in docs/equations.md)
///
/// with g, v and c as in ShadowRaySums. The correction e of the approximate H0 estimates the mean of g - 1 by shrinkage
/// in two steps (empirical Bayes): the mean over the surrounding patches is shrunk towards 0, that of the patch towards
/// the result. If typical errors have size b (0.1 for the first, 0.03 for the second), m rays get
/// the weight b^2 m / (b^2 m + variance of g + 0.01). There is hardly any noise where H0 is exact and all lights are
/// hidden, or all are visible and have the same colour.
class GatheredLight
{
public:
    /// Keeps references to the scene and the lights.
    GatheredLight(const Scene& scene, const SceneLights& lights)
        : scene_(scene), lights_(lights), cuts_(lights.cuts.get()), sums_(scene.patch_count())
    {
    }

    /// [W/m^2] Approximate irradiance H0 without obstacles, mean of the channels.
    double unoccluded(std::uint32_t patch) const { return cuts_.irradiance(patch); }
    double cluster_bytes() const { return cuts_.bytes(); }               ///< [bytes] memory of the light cuts
    double rays(std::uint32_t patch) const { return sums_[patch].rays; } ///< number of rays cast so far

    /// The division of `patches` patches into blocks, the units of work of cast().
    static Blocks blocks(std::uint32_t patches) { return {patches, 256}; }

    /// Casts the allotted rays of the patches in the blocks range.next ... range.end - 1 of blocks(), and adds them to
    /// the sums. If the run is stopped, only the first of these blocks are done. Moves range.next past the blocks done.
    /// Ray n of the allotment takes the item first_item + n of the sequence.
    void cast(const Allotment& rays, const Sequence& sequence, std::uint64_t first_item, ShardRange& range,
              const RunControl& run);

    /// [W/m^2] Per patch: standard deviation of its irradiance if a single ray estimates it. It comes from the rays of
    /// the patch if they are 16 or more, otherwise from those of the surrounding patches as well.
    std::vector<double> deviations() const;

    /// [W] Per patch: estimated incident power from all lights; 0 for a patch without rays, or with no g above 0.
    std::vector<Rgb> incident() const;

    /// Saves the sums to a checkpoint or restores them.
    void visit(Archive& archive) { archive.list<double>("sights", sums_); }

private:
    template <class Make>
    auto of_patches(const Make& make) const;

    const Scene& scene_;
    const SceneLights& lights_;
    const LightCuts& cuts_;
    std::vector<ShadowRaySums> sums_; ///< per patch
};

/// [W] Incident power of every patch from the sky alone, estimated twice with the same rays.
struct GatheredSkylight
{
    /// The sky's light times the fraction of rays that reach it. With fewer than 16 rays, a patch takes this fraction
    /// from the surrounding patches too, corrected so that the mean over its group, the patches of one material on one
    /// side, is that of the group's own rays. Exact where all rays reach the sky.
    std::vector<Rgb> incident;
    /// Each patch by its own rays alone, most often nothing if there are few of them, but right on the average (Horvitz
    /// and Thompson 1952): nothing gets from the patches around into a closed space.
    std::vector<Rgb> by_own_rays;
};

/// Casts `rays` rays from the patches, spread evenly over the area of each group, and with at least one for each group
/// if there are enough. They take the items first_item and following. Zeros if the run is stopped.
GatheredSkylight gathered_skylight(const Scene& scene, const SurfaceTree& patches, const Sequence& sequence,
                                   std::uint64_t first_item, std::uint64_t rays, const RunControl& run);

/// [W/m^2] Radiosity of every patch after one reflection: its emittance plus the reflected light of lamps, sky and sun.
/// The light is gathered whatever the method, with the same rays in every call.
std::vector<Rgb> direct_radiosity(const Scene& scene, int threads);

} // namespace multipath
