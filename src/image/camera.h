#pragma once

#include "geometry/intersector/hit_lists.h"
#include "geometry/intersector/intersector.h"
#include "geometry/line.h"
#include "geometry/pi.h"
#include "geometry/vec3.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

constexpr double radians_per_degree = pi / 180.0;

/// A pinhole camera: what it stands on, what it looks at, and how much it sees.
struct Camera
{
    Vec3 eye;
    Vec3 target;
    Vec3 up = {0.0, 1.0, 0.0};
    double field_of_view = 60.0; ///< [degrees] vertical, between 0 and 180
};

/// [pixels] Squared, three bytes a pixel still fit in one PNG chunk.
constexpr int largest_picture_side = 16384;

/// The camera whose picture of `rows` rows is the middle of the given one's picture of `rows_before` rows.
Camera cropped(Camera camera, int rows_before, int rows);

/// The rays of a camera through a picture of width x height square pixels.
class PixelRays
{
public:
    /// Throws SettingsError for a camera without a direction, with `up` along its direction, or with an impossible
    /// field of view, and for a picture without pixels or with a side above the largest.
    PixelRays(const Camera& camera, int width, int height);

    /// The ray through a point of the picture in pixels from its top left corner; (0.5, 0.5) is the first pixel's
    /// centre. Its direction has length one.
    Line through(double x, double y) const;

private:
    Vec3 eye_;
    Vec3 top_left_; ///< from the eye, at distance one along the view
    Vec3 per_x_;    ///< one pixel to the right
    Vec3 per_y_;    ///< one pixel down
};

/// Finds the first sides that exist along rays: the backs of one-sided surfaces are looked through, so that a closed
/// room can be seen from outside. To be used by one thread.
class VisibleHits
{
public:
    explicit VisibleHits(const Scene& scene) : scene_(scene) {}

    /// Of each ray what is seen, or nothing; valid until the next call.
    const std::vector<std::optional<Hit>>& first(const std::vector<Line>& rays);

    /// What each of these rays meets first, whether or not it is seen.
    const FirstHits& nearest() const { return nearest_; }

private:
    bool is_seen(const Hit& hit) const; ///< not the back of what has no patches there, nor the sky from outside
    void look_through_backs(const std::vector<Line>& rays);

    const Scene& scene_;
    std::vector<std::uint32_t> from_; ///< nowhere
    FirstHits nearest_;
    std::vector<std::optional<Hit>> seen_;
    std::vector<std::size_t> behind_; ///< rays that meet a back first
    std::vector<Line> lines_;         ///< the same
    HitLists hits_;
};

/// Calls visit(x, hit) for the middles of the pixels of row y, from left to right.
template <class Visit>
void for_each_visible(const PixelRays& pixels, int width, int y, VisibleHits& visible, const Visit& visit)
{
    std::vector<Line> rays;
    for (int x = 0; x < width; ++x)
        rays.push_back(pixels.through(x + 0.5, y + 0.5));
    const std::vector<std::optional<Hit>>& hits = visible.first(rays);
    for (int x = 0; x < width; ++x)
        visit(x, hits[static_cast<std::size_t>(x)]);
}

} // namespace multipath
