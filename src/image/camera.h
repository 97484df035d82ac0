#pragma once

#include "base/elementary.h"
#include "geometry/intersector/hit_lists.h"
#include "geometry/intersector/intersector.h"
#include "geometry/line.h"
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

/// [pixels] Largest width and height of a picture. The bytes of a square picture of this size, three per pixel, fit
/// into one PNG chunk.
constexpr int largest_picture_side = 16384;

/// Camera for a crop of a picture: a picture of `rows` rows by the returned camera equals the middle rows of a picture
/// of `rows_before` rows by `camera`.
Camera cropped(Camera camera, int rows_before, int rows);

/// The rays of a camera through a picture of width x height square pixels.
class PixelRays
{
public:
    /// Throws SettingsError for a camera that is not finite, has no viewing direction, has an `up` of length zero or
    /// parallel to that direction, or has a field of view outside (0, 180) degrees. Also throws it for a width or
    /// height that is not 1 ... largest_picture_side.
    PixelRays(const Camera& camera, int width, int height);

    /// Ray through the point (x, y) of the picture, with a unit direction. (x, y) is in pixels from the top left
    /// corner; (0.5, 0.5) is the centre of the first pixel.
    Line through(double x, double y) const;

    int width() const { return width_; }   ///< [pixels]
    int height() const { return height_; } ///< [pixels]

private:
    int width_;
    int height_;
    Vec3 eye_;
    Vec3 top_left_; ///< vector from the eye to the top left corner of the picture, on the image plane at distance one
    Vec3 per_x_;    ///< step of one pixel to the right on that plane
    Vec3 per_y_;    ///< step of one pixel down on that plane
};

/// Finds the first visible hit of each ray. The backs of one-sided surfaces are transparent, so that a closed room can
/// be seen from outside; the back of the sky is transparent in every scene. Holds reusable buffers: use one object per
/// thread. The scene must outlive the object.
class VisibleHits
{
public:
    explicit VisibleHits(const Scene& scene) : scene_(scene) {}

    /// The first visible hit of each ray, in the order of the rays; nothing if a ray meets no visible side. The
    /// reference is valid until the next call.
    const std::vector<std::optional<Hit>>& first(const std::vector<Line>& rays);

    /// The first hit of each ray of the last call of first(), visible or not.
    const FirstHits& nearest() const { return nearest_; }

private:
    bool is_seen(const Hit& hit) const; ///< false for the back of a one-sided surface or of the sky
    void look_through_backs(const std::vector<Line>& rays);

    const Scene& scene_;
    std::vector<std::uint32_t> from_; ///< per ray: Intersector::no_surface, since the rays start in free space
    FirstHits nearest_;
    std::vector<std::optional<Hit>> seen_;
    std::vector<std::size_t> back_first_; ///< indices of the rays whose first hit is not visible
    std::vector<Line> lines_;             ///< rays of back_first_ that are traced together
    HitLists hits_;
};

/// The first visible hit of the ray through each pixel centre, row by row from the top left; nothing where nothing is
/// visible.
std::vector<std::optional<Hit>> visible_hits(const Scene& scene, const PixelRays& rays, int threads);

} // namespace multipath
