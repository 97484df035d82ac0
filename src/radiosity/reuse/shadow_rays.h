#pragma once

#include "parallel/run_control.h"
#include "radiosity/reuse/light_pair.h"
#include "sampling/sequence.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// A patch and an emitting surface whose fronts face each other.
struct GatherPair
{
    std::uint32_t light; ///< place in GatherPairs::lights
    float exchange;      ///< [m^2] if nothing stands between
};

/// All such pairs of the patches of a scene and some lights.
struct GatherPairs
{
    std::vector<std::uint32_t> lights;   ///< surfaces
    std::vector<GatherPair> pairs;       ///< patch by patch, each in the order of the lights
    std::vector<std::size_t> first_pair; ///< of each patch; one entry more than patches
    /// [W] Per patch: from lights in the same plane across a gap of no width, as under a box that stands on a lamp.
    /// They are no pairs: nothing can stand between.
    std::vector<Rgb> contact;

    /// The number of a pair.
    std::optional<std::size_t> find(std::uint32_t patch, std::uint32_t light) const;
};

GatherPairs find_gather_pairs(const Scene& scene, std::vector<std::uint32_t> lights, int threads);

/// The geometry of a patch and an emitting surface.
LightPair light_pair(const Scene& scene, std::uint32_t patch, std::uint32_t light_surface);

/// [W/m^2] Of a surface's front.
Rgb surface_emittance(const Scene& scene, std::uint32_t surface);

/// How the rays of a pair are chosen.
enum class Look : std::uint8_t {
    at_likely_points, ///< points chosen by the kernel between them: without bias for a single ray
    at_all_points,    ///< uniform points, weighted with the kernel: better for many rays
    around,           ///< cosine-distributed directions: for a light so near that the kernel has peaks
};

/// For every pair, given how many rays it gets on the average.
std::vector<Look> choose_looks(const Scene& scene, const GatherPairs& pairs, const std::vector<double>& rays);

/// What the rays of one pair found, each counted with its weight.
struct Sight
{
    double all = 0.0;
    double free = 0.0;

    /// [1] Visible share; 0 without rays.
    double share() const { return all > 0.0 ? free / all : 0.0; }
};

/// Shadow rays for every pair, `deserved` on the average, rounded by a running sum that begins with `offset` in [0, 1).
/// Ray number n of all takes the item first_item + n.
struct ShadowRays
{
    std::vector<double> deserved;
    double offset = 0.0;
    std::uint64_t first_item = 0;
};

/// Casts the rays and adds what they find to the sights. Returns their number. A checkpoint must hold the sights and
/// what the pairs deserve besides what this function makes it hold.
std::uint64_t cast_shadow_rays(const Scene& scene, const GatherPairs& pairs, const std::vector<Look>& looks,
                               const ShadowRays& rays, const Sequence& sequence, const RunControl& run,
                               std::vector<Sight>& sights);

/// Random bits that are a function of the item and tell nothing of it.
std::uint64_t bits_from(const Item& item);

} // namespace multipath
