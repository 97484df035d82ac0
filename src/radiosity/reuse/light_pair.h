#pragma once

#include "geometry/line.h"
#include "geometry/polygon.h"
#include "geometry/surface.h"
#include "sampling/sequence.h"

#include <array>
#include <cstddef>
#include <optional>

namespace multipath {

/// A flat region in up to three pieces.
class FlatRegion
{
public:
    explicit FlatRegion(const Surface& whole);
    /// Triangles around the polygon's first corner.
    explicit FlatRegion(const FlatPolygon& polygon);

    Vec3 uniform_point(double a, double b) const;

    double area() const { return area_end_[count_ - 1]; } ///< [m^2]

    const Surface* begin() const { return pieces_.data(); }
    const Surface* end() const { return pieces_.data() + count_; }

private:
    void append(const Surface& piece);

    std::array<Surface, 3> pieces_;
    std::array<double, 3> area_end_{}; ///< of the pieces up to this one
    std::size_t count_ = 0;
};

/// A receiving patch and a light, each cut to the part that lies in front of the other one's plane. Sending 1 W/m^2
/// from its front, the light would give the patch `exchange` watts if nothing stood between.
class LightPair
{
public:
    /// `clamp_area` [m^2]: the kernel between points closer than about its size is not trusted.
    LightPair(const Surface& receiver, const Surface& light, double clamp_area);

    bool faces() const { return faces_; } ///< the rest needs this
    double exchange() const;              ///< [m^2]

    /// A uniform point of each part.
    struct Points
    {
        Vec3 on_receiver;
        Vec3 on_light;
    };
    Points points(const Item& item) const;

    /// Closer to each other than half the receiver is wide: the kernel then varies so much that rays spread over the
    /// light tell little.
    bool is_near() const;
    /// Where a ray that leaves the receiver's front would meet the light's.
    std::optional<Vec3> target(const Line& ray) const;

    /// [1/m^2] cos cos' / (pi r^2), at most 1 / clamp_area, and never 0.
    double kernel(const Points& points) const;

private:
    Surface receiver_surface_;
    Vec3 receiver_normal_;
    Vec3 light_normal_;
    FlatPolygon light_outline_;
    FlatPolygon receiver_outline_;
    FlatRegion receiver_;
    FlatRegion light_;
    double clamp_area_;
    bool faces_;
};

} // namespace multipath
