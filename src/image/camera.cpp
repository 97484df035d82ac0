#include "image/camera.h"

#include "base/errors.h"
#include "base/lists.h"
#include "image/image.h"
#include "parallel/blocks.h"
#include "sampling/warp.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace multipath {

namespace {

bool is_finite(Vec3 a)
{
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

void require_picture(int width, int height)
{
    if (width < 1 || height < 1 || width > largest_picture_side || height > largest_picture_side)
        throw SettingsError("picture size " + std::to_string(width) + " x " + std::to_string(height) +
                            ": width and height must be between 1 and " + std::to_string(largest_picture_side));
}

void require_camera(const Camera& camera)
{
    if (!is_finite(camera.eye) || !is_finite(camera.target) || !is_finite(camera.up))
        throw SettingsError("camera: eye, target and up must be finite numbers");
    if (!(camera.field_of_view > 0.0 && camera.field_of_view < 180.0))
        throw SettingsError("camera: the field of view must be between 0 and 180 degrees");
    const Vec3 view = camera.target - camera.eye;
    if (length(view) == 0.0)
        throw SettingsError("camera: eye and target are the same point, so there is no direction to look in");
    if (!std::isfinite(length(view)))
        throw SettingsError("camera: eye and target are too far apart for a direction to be computed");
    if (length(camera.up) == 0.0)
        throw SettingsError("camera: the up direction has length zero");
    // For a smaller sine, rounding errors would determine the rotation of the picture.
    if (length(cross(normalized(view), normalized(camera.up))) < 1e-6)
        throw SettingsError("camera: the up direction is parallel to the view, choose another one");
}

} // namespace

Camera cropped(Camera camera, int rows_before, int rows)
{
    const double half_height = elementary::tan(0.5 * camera.field_of_view * radians_per_degree) * rows / rows_before;
    camera.field_of_view = 2.0 / radians_per_degree * elementary::atan(half_height);
    return camera;
}

PixelRays::PixelRays(const Camera& camera, int width, int height) : width_(width), height_(height), eye_(camera.eye)
{
    require_picture(width, height);
    require_camera(camera);
    const Vec3 forward = normalized(camera.target - camera.eye);
    const Vec3 right = normalized(cross(forward, camera.up));
    const Vec3 up = cross(right, forward);
    const SinCos half_angle = sin_cos_of_turns(0.5 * camera.field_of_view / 360.0);
    const double pixel = 2.0 * half_angle.sin / half_angle.cos / height;
    per_x_ = pixel * right;
    per_y_ = -pixel * up;
    top_left_ = forward - (0.5 * width) * per_x_ - (0.5 * height) * per_y_;
}

Line PixelRays::through(double x, double y) const
{
    return {eye_, normalized(top_left_ + x * per_x_ + y * per_y_)};
}

bool VisibleHits::is_seen(const Hit& hit) const
{
    return hit.front || (scene_.two_sided() && !scene_.is_sky(hit.surface));
}

const std::vector<std::optional<Hit>>& VisibleHits::first(const std::vector<Line>& rays)
{
    from_.assign(rays.size(), Intersector::no_surface);
    scene_.intersector().closest_hits_from(from_.data(), rays.data(), rays.size(), nearest_);
    seen_.assign(rays.size(), std::nullopt);
    back_first_.clear();
    for (std::size_t k = 0; k < rays.size(); ++k) {
        if (!nearest_.is_hit(k))
            continue;
        if (is_seen(nearest_[k]))
            seen_[k] = nearest_[k];
        else
            back_first_.push_back(k);
    }
    look_through_backs(rays);
    return seen_;
}

void VisibleHits::look_through_backs(const std::vector<Line>& rays)
{
    constexpr std::size_t at_a_time = 256; // bounds the memory: a ray may have thousands of hits
    for (std::size_t first = 0; first < back_first_.size(); first += at_a_time) {
        const std::size_t end = std::min(back_first_.size(), first + at_a_time);
        lines_.clear();
        for (std::size_t i = first; i < end; ++i)
            lines_.push_back(rays[back_first_[i]]);
        scene_.intersector().all_hits(lines_.data(), lines_.size(), hits_);
        for (std::size_t i = first; i < end; ++i) {
            const HitLists::List hits = hits_[i - first];
            const Hit* const front =
                std::find_if(hits.begin(), hits.end(), [this](const Hit& hit) { return is_seen(hit); });
            if (front != hits.end())
                seen_[back_first_[i]] = *front;
        }
    }
}

std::vector<std::optional<Hit>> visible_hits(const Scene& scene, const PixelRays& rays, int threads)
{
    std::vector<std::optional<Hit>> hits(pixel_index(rays.width(), 0, rays.height()));
    parallel_blocks(static_cast<std::uint64_t>(rays.height()), threads, [&](std::uint64_t row) {
        const int y = static_cast<int>(row);
        const auto lines = serial_list(rays.width(), [&](int x) { return rays.through(x + 0.5, y + 0.5); });
        VisibleHits visible(scene);
        const std::vector<std::optional<Hit>>& found = visible.first(lines);
        std::copy(found.begin(), found.end(), &hits[pixel_index(rays.width(), 0, y)]);
    });
    return hits;
}

} // namespace multipath
