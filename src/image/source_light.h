#pragma once

#include "geometry/flat_polygon.h"
#include "image/place.h"
#include "image/ray_fan.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// The light that comes straight from the sources of a scene to any of its points. What would arrive if nothing stood
/// between has a closed form; shadow rays tell the share that does. So a point that is lit by all or by none of its
/// sources has no noise. Immutable and safe to share between threads.
class SourceLight
{
public:
    /// The scene must outlive this object.
    explicit SourceLight(const Scene& scene);

    /// [W/m^2] At a place, by one ray for each item of the fan, which takes the item's first two numbers. `offset` in
    /// [0, 1) decides which sources get the rays if these are few, and is to differ from place to place.
    Rgb irradiance(const Place& place, RayFan& fan, double offset) const;

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

    std::vector<View> views(const Place& place, double offset) const;

    const Scene& scene_;
    std::vector<Source> sources_;
    double power_ = 0.0; ///< [W] of all sources
};

} // namespace multipath
