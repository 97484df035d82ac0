#pragma once

#include "parallel/blocks.h"
#include "parallel/run_control.h"
#include "radiosity/reuse/light_tree.h"
#include "radiosity/reuse/surface_tree.h"
#include "sampling/allotment.h"
#include "sampling/sequence.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

namespace multipath {

/// Trees over the lights and over the patches of a scene, and the light cut of every patch. They are the same for all
/// runs, and are built on first use. Safe to share between threads; the scene must outlive this object.
class SceneLights
{
public:
    SceneLights(const Scene& scene, int threads) : scene_(scene), threads_(threads) {}

    const LightTree& tree() const;
    const LightCuts& cuts() const;
    const SurfaceTree& patches() const;
    int threads() const { return threads_; }

private:
    const Scene& scene_;
    int threads_;
    mutable std::once_flag lights_found_;
    mutable std::once_flag patches_found_;
    mutable std::optional<LightTree> tree_;
    mutable std::optional<LightCuts> cuts_;
    mutable std::optional<SurfaceTree> patches_;
};

/// Sums over the shadow rays of a patch. For each ray, g is its true kernel divided by the assumed kernel of its
/// cluster, and v is 1 if nothing blocks it, else 0.
struct ShadowRaySums
{
    double rays = 0.0;
    double kernel = 0.0; ///< sum of g
    double error = 0.0;  ///< sum of g - 1 over the rays to clusters whose irradiance is approximate
    double square = 0.0; ///< sum of (g - 1)^2 over the same rays
    double free = 0.0;   ///< number of unblocked rays
    Rgb light;           ///< sum of g v c, where c is the colour of the light, with mean 1
};

/// Direct light, gathered by shadow rays from the patches. Each patch casts rays to its lights in proportion to their
/// unoccluded irradiance, H0 in total. Its irradiance is
///
///   H0 (1 + e) sum of g v c / sum of g        (R5)
///
/// Here e estimates the mean of g - 1, which removes the effect of the approximations in H0. It is a sum of two
/// shrinkage estimates (empirical Bayes), first of the mean over the surrounding patches, then of the patch's own
/// deviation from it. If typical errors have size b (0.1 and 0.03), m rays get the weight b^2 m / (b^2 m + variance of
/// g). There is no noise where H0 is exact and the lights are fully visible or fully hidden.
class GatheredLight
{
public:
    /// Keeps references to the scene and the lights.
    GatheredLight(const Scene& scene, const SceneLights& lights);
    GatheredLight(const GatheredLight&) = delete;
    GatheredLight& operator=(const GatheredLight&) = delete;

    /// [W/m^2] Approximate irradiance without obstacles, mean of the channels.
    double unoccluded(std::uint32_t patch) const { return cuts_.irradiance(patch); }
    double cluster_bytes() const { return cuts_.bytes(); }               ///< memory of the light cuts
    double rays(std::uint32_t patch) const { return sums_[patch].rays; } ///< cast so far

    /// The blocks of patches that `cast` processes one by one.
    static Blocks blocks(std::uint32_t patches);

    /// Casts the allotted rays of the blocks range.next ... range.end - 1, or of fewer if the run is stopped. Ray n
    /// takes the item first_item + n.
    void cast(const Allotment& rays, const Sequence& sequence, std::uint64_t first_item, ShardRange& range,
              const RunControl& run);

    /// [W/m^2] Standard deviation of the irradiance estimated by a single ray of each patch. Estimated from its own
    /// rays if they are many, otherwise with those of the surrounding patches.
    std::vector<double> deviations() const;

    /// [W] Incident power of each patch.
    std::vector<Rgb> incident() const;

    void visit(Archive& archive); ///< for a checkpoint

private:
    template <class Value, class Make>
    std::vector<Value> of_patches(const Make& make) const;
    std::vector<RaySums> visible_shares() const;

    const Scene& scene_;
    const LightTree& tree_;
    const LightCuts& cuts_;
    const SurfaceTree& patches_;
    int threads_;
    std::vector<ShadowRaySums> sums_; ///< per patch
};

/// [W/m^2] Radiosity of every patch after one reflection: its emittance plus the reflected direct light. Independent of
/// the method, and deterministic.
std::vector<Rgb> direct_radiosity(const Scene& scene, int threads);

} // namespace multipath
