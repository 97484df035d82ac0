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

/// The lights of a scene as its patches see them, and its patches in a tree, for what their rays have in common: the
/// same for all runs. Found when first asked for. Safe to share between threads; the scene must outlive it.
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

/// What the rays from a patch towards the lights found. Each has g, its true kernel over what the cluster that it was
/// sent to is taken to give, and v, 1 if it is free and 0 if not.
struct Sight
{
    double rays = 0.0;
    double kernel = 0.0; ///< sum of g
    double error = 0.0;  ///< sum of g - 1 of the rays to clusters whose irradiance is not exact
    double square = 0.0; ///< sum of (g - 1)^2 of these
    double free = 0.0;   ///< number of free rays
    Rgb light;           ///< sum of g v c, c the colour of the light, of mean 1
};

/// Direct light, found from the receivers' ends. A patch sends rays to its lights in proportion to what these would
/// give it, P in all, if nothing stood in between; it gets
///
///   P (1 + e) sum of g v c / sum of g        (R5)
///
/// e is the mean of g - 1: with it the approximations in P have no effect. It is taken in two steps, from the patches
/// around and from the patch itself, each only as far as it is known better than its usual size, b = 0.1 and 0.03: of m
/// rays b^2 m / (b^2 m + variance of g). Where P is exact and nothing is in between, or everything, there is no noise.
class GatheredLight
{
public:
    /// Refers to the lights.
    GatheredLight(const Scene& scene, const SceneLights& lights);
    GatheredLight(const GatheredLight&) = delete;
    GatheredLight& operator=(const GatheredLight&) = delete;

    /// [W/m^2] What the patch would get with nothing in between, about; the mean of the channels.
    double unoccluded(std::uint32_t patch) const { return cuts_.irradiance(patch); }
    double cluster_bytes() const { return cuts_.bytes(); }                 ///< of memory
    double rays(std::uint32_t patch) const { return sights_[patch].rays; } ///< so far

    /// The blocks of patches in which `cast` works.
    static Blocks blocks(std::uint32_t patches);

    /// Casts the allotted rays of the blocks range.next ... range.end - 1, or of fewer if the run is stopped. Ray
    /// number n takes the item first_item + n.
    void cast(const Allotment& rays, const Sequence& sequence, std::uint64_t first_item, SharedRange& range,
              const RunControl& run);

    /// [W/m^2] Standard deviation of what one ray of each patch tells, from its own rays if they are many, or those
    /// of the patches around it.
    std::vector<double> deviations() const;

    /// [W] per patch.
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
    std::vector<Sight> sights_; ///< per patch
};

/// [W/m^2] Radiosity of every patch if light were reflected only once: what the patch emits, and what it reflects of
/// the light that comes straight from the sources. For any method, without chance: always the same.
std::vector<Rgb> direct_radiosity(const Scene& scene, int threads);

} // namespace multipath
