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

/// A pinhole camera.
struct Camera
{
    Vec3 eye;
    Vec3 target; ///< point in the middle of the picture
    Vec3 up = {0.0, 1.0, 0.0};
    double field_of_view = 60.0; ///< [degrees] vertical, between 0 and 180
};

/// [pixels] The bytes of a square picture of this size, three per pixel, fit into one PNG chunk.
constexpr int largest_picture_side = 16384;

/// Camera for a crop: its picture with `rows` rows is the middle of the original picture with `rows_before` rows.
Camera cropped(Camera camera, int rows_before, int rows);

/// The rays of a camera through a picture of width x height square pixels.
class PixelRays
{
public:
    /// Throws SettingsError for a camera that is not finite, has no viewing direction, has `up` parallel to it, or has
    /// a field of view outside (0, 180) degrees, and for a picture side that is not 1 ... largest_picture_side.
    PixelRays(const Camera& camera, int width, int height);

    /// Ray through the point (x, y) of the picture, with a unit direction. (x, y) is in pixels from the top left
    /// corner; (0.5, 0.5) is the centre of the first pixel.
    Line through(double x, double y) const;

private:
    Vec3 eye_;
    Vec3 top_left_; ///< from the eye, on the image plane at distance one
    Vec3 per_x_;    ///< one pixel to the right
    Vec3 per_y_;    ///< one pixel down
};

/// Finds the first visible hit of each ray. The backs of one-sided surfaces are transparent, so that a closed room can
/// be seen from outside. Holds reusable buffers: one object per thread.
class VisibleHits
{
public:
    explicit VisibleHits(const Scene& scene) : scene_(scene) {}

    /// The first visible hit of each ray, or nothing. The reference is valid until the next call.
    const std::vector<std::optional<Hit>>& first(const std::vector<Line>& rays);

    /// The first hit of each ray of the last call, visible or not.
    const FirstHits& nearest() const { return nearest_; }

private:
    bool is_seen(const Hit& hit) const; ///< false for the back of a one-sided surface or of the sky
    void look_through_backs(const std::vector<Line>& rays);

    const Scene& scene_;
    std::vector<std::uint32_t> from_; ///< no_surface for every ray
    FirstHits nearest_;
    std::vector<std::optional<Hit>> seen_;
    std::vector<std::size_t> back_first_; ///< indices of the rays whose first hit is not visible
    std::vector<Line> lines_;             ///< a batch of these rays
    HitLists hits_;
};

/// Traces the rays through the pixel centres of row y and calls visit(x, hit) for each, from left to right.
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
