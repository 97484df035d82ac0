#pragma once

#include "geometry/flat_polygon.h"
#include "image/clear_sight.h"
#include "image/place.h"
#include "image/ray_fan.h"
#include "sampling/sequence.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// The light that comes straight from the sources of a scene to any of its points. What would arrive if nothing stood
/// between has a closed form; shadow rays tell the share that does, of sources that something may hide. So a point that
/// is lit by all or by none of its sources has no noise. Immutable and safe to share between threads.
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
    };

    /// What a place sees of a source if nothing stands between.
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
    Sight sight(const Place& place, double offset) const;

    const Scene& scene_;
    std::vector<Source> sources_;
    ClearSight clear_sight_; ///< of the sources
    double power_ = 0.0;     ///< [W] of all sources
};

} // namespace multipath
