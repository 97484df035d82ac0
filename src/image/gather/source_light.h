#pragma once

#include "geometry/polygon.h"
#include "image/gather/place.h"
#include "sampling/sequence.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace multipath {

/// Full visibility between patches and surfaces (shaft culling): certain where no surface reaches into the convex hull
/// of the two. Computed on first use, so that only the patches in a picture are tested. Safe to share between threads.
class ClearSight
{
public:
    /// `targets`: numbers of surfaces. The scene must outlive this object. In very large scenes, where the search would
    /// cost more than it saves, no pair is clear.
    ClearSight(const Scene& scene, std::vector<std::uint32_t> targets);

    /// True if nothing stands between any point of a patch and any of a target, given by its index in the list. False
    /// if that is not certain, and for Scene::no_patch.
    bool is_clear(std::uint32_t patch, std::size_t target) const;

private:
    bool find(std::uint32_t patch, std::uint32_t target) const;

    const Scene& scene_;
    std::vector<std::uint32_t> targets_;
    double touching_; ///< [scene units] smaller depths inside the hull count as touching
    mutable std::vector<std::atomic<std::uint8_t>> known_; ///< per patch and target: 0 not yet, 1 no, 2 yes
};

/// The light that comes straight from the sources of a scene to any of its points. The unoccluded irradiance has a
/// closed form; shadow rays estimate the visible share of sources that something may hide. A point that is lit by all
/// or by none of its sources has no noise. Immutable and safe to share between threads.
class SourceLight
{
public:
    /// The scene must outlive this object.
    explicit SourceLight(const Scene& scene);

    /// Consecutive items of a sequence, one for each ray, which takes the item's first two numbers.
    struct Items
    {
        const Sequence& sequence;
        std::uint64_t first;
        std::size_t count;
    };

    /// [W/m^2] At a place. `offset` in [0, 1) decides which sources get the rays if these are few, and is to differ
    /// from place to place; `fan` is room to work in.
    Rgb irradiance(const Place& place, const Items& items, double offset, RayFan& fan) const;

private:
    struct Source
    {
        std::uint32_t surface;
        Rgb emittance; ///< [W/m^2]
        double power;  ///< [W] mean of the channels
        Vec3 centre;
        double radius; ///< of a sphere around the centre that holds it
    };

    /// A source as it is seen from a place if nothing stands between.
    struct View
    {
        std::uint32_t surface;
        FlatPolygon outline; ///< of the part above the horizon
        double form_factor;  ///< [1] of the outline
        Rgb irradiance;      ///< [W/m^2]
    };

    /// The sources that a place sees: `clear` of those that nothing can hide, and views of the others.
    struct Sight
    {
        Rgb clear; ///< [W/m^2] irradiance
        std::vector<View> views;
    };

    static std::vector<Source> sources_of(const Scene& scene);
    static std::vector<std::uint32_t> surfaces_of(const std::vector<Source>& sources);
    static double importance(const Source& source, const Place& place);
    Sight sight(const Place& place, double offset) const;

    const Scene& scene_;
    std::vector<Source> sources_;
    ClearSight clear_sight_; ///< of the sources
};

} // namespace multipath
