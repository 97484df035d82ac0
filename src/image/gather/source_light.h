#pragma once

#include "geometry/polygon.h"
#include "image/gather/gather_point.h"
#include "sampling/sequence.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace multipath {

/// Conservative test of full visibility between patches and target surfaces. A patch and a target see each other
/// entirely if no other surface reaches into their convex hull (shaft culling, Haines and Wallace 1991). Results are
/// computed on first use and cached, so that only the patches in a picture are tested. Safe to share between threads.
class ShaftVisibility
{
public:
    /// `targets`: number of target surfaces. The scene must outlive this object. In a large scene, of more than 1000
    /// surfaces or 2^24 pairs, the tests would cost too much time or memory: none is made, and no pair counts as fully
    /// visible.
    ShaftVisibility(const Scene& scene, std::size_t targets);

    /// True if certainly nothing lies between any point of the patch and any point of target `number`, which is always
    /// the same `surface`; false if something may. False for Scene::no_patch.
    bool is_fully_visible(std::uint32_t patch, std::size_t number, std::uint32_t surface) const;

private:
    bool find(std::uint32_t patch, std::uint32_t target) const;

    const Scene& scene_;
    std::size_t targets_;
    double touching_; ///< [scene units] a surface that reaches less deep into the hull only touches it
    /// Per patch and target: 0 unknown, 1 false, 2 true; empty in a large scene.
    mutable std::vector<std::atomic<std::uint8_t>> known_;
};

/// Direct light: the irradiance of points by the sources of a scene, which are all surfaces with emittance, the sky
/// included, and the sun. Of the surfaces, the unoccluded irradiance has a closed form. Shadow rays estimate the
/// visible share of sources that may be occluded. There is no noise where all sources, or none, are visible, unless the
/// scene has more than 32 sources: then only about 32 are sampled per point. Immutable and safe to share between
/// threads.
class SourceLight
{
public:
    /// The scene must outlive this object.
    explicit SourceLight(const Scene& scene);

    /// Consecutive items of a sequence (an item is one of its points, sequence.h). Each shadow ray uses the first two
    /// numbers of one item.
    struct Items
    {
        const Sequence& sequence;
        std::uint64_t first; ///< index of the first item
        std::size_t count;   ///< number of shadow rays
    };

    /// [W/m^2] Irradiance of a point by all sources, the sun included. `offset` in [0, 1) shifts the systematic
    /// sampling of sources and rays, and should differ from point to point. `fan`: reusable buffers of one thread.
    Rgb irradiance(const GatherPoint& receiver, const Items& items, double offset, RayFan& fan) const;

private:
    struct Source
    {
        std::uint32_t surface;
        Rgb emittance; ///< [W/m^2]
        double power;  ///< [W] mean of the channels
        Vec3 centre;
        double radius; ///< [scene units] radius of a bounding sphere around the centre
    };

    /// A source as seen from a receiving point, without occluders.
    struct View
    {
        std::uint32_t surface;
        FlatPolygon outline; ///< the part of the source above the horizon of the point
        double form_factor;  ///< [1] form factor from the point to the outline
        Rgb irradiance;      ///< [W/m^2] unoccluded, divided by the probability of choosing the source
    };

    /// The sources above the horizon of a point.
    struct SourceViews
    {
        Rgb clear;               ///< [W/m^2] irradiance by the sources that are certainly fully visible
        std::vector<View> views; ///< the other sources
    };

    static std::vector<Source> sources_of(const Scene& scene);
    static double importance(const Source& source, const GatherPoint& receiver);
    SourceViews source_views(const GatherPoint& receiver, double offset) const;

    const Scene& scene_;
    std::vector<Source> sources_;
    ShaftVisibility shafts_; ///< its targets are the sources
};

} // namespace multipath
