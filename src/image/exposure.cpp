// A point is outdoors, as seen from the camera, if it sees much more of the sky than the camera does. So all that a
// window shows is outdoors, but nothing in a courtyard in which the camera stands.

#include "image/exposure.h"

#include "image/gather/gather_point.h"
#include "sampling/warp.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace multipath {

namespace {

constexpr int sky_rays = 16;
constexpr double much_more = 0.2;    // share of the hemisphere above
constexpr double most_white = 0.125; // share of the surfaces in the picture

/// [1] Share of the upper hemisphere in which a point sees the sky. `fan`: reusable buffers.
double sky_share(const Scene& scene, const GatherPoint& point, Vec3 up, RayFan& fan)
{
    const Vec3 aside = normalized(cross(up, std::abs(up.z) < 0.9 ? Vec3{0.0, 0.0, 1.0} : Vec3{1.0, 0.0, 0.0}));
    const Vec3 ahead = cross(aside, up);
    fan.rays.clear();
    for (int k = 0; k < sky_rays; ++k) { // a spiral, uniform by solid angle
        const double rise = (k + 0.5) / sky_rays;
        const SinCos turn = sin_cos_of_turns(std::fmod(k * 0.6180339887498949, 1.0)); // golden section
        const Vec3 level = turn.cos * aside + turn.sin * ahead;
        const Vec3 direction = std::sqrt(1.0 - rise * rise) * level + rise * up;
        if (point.surface == GatherPoint::free || dot(direction, point.normal) > 0.0)
            fan.rays.push_back({point.point, direction});
    }
    const FirstHits& hits = fan.trace(scene, point.surface);
    int seen = 0;
    for (std::size_t k = 0; k < fan.rays.size(); ++k)
        seen += !hits.is_hit(k) || scene.is_sky(hits[k].surface) ? 1 : 0;
    return static_cast<double>(seen) / sky_rays;
}

/// The radiosities [W/m^2] of the pixels of a preview that count and are not black.
struct Preview
{
    std::vector<Rgb> all;
    std::vector<Rgb> lit;      ///< those that do not emit
    bool shows_little = false; ///< less than a twentieth of the picture counts
};

/// The rays of a small picture, with sides of at most 160 pixels.
PixelRays preview_rays(const Camera& camera, const RenderOptions& options)
{
    const int shrink = (std::max({options.width, options.height, 1}) + 159) / 160;
    const auto shrunk = [shrink](int side) { return std::min(side, std::max(1, side / shrink)); };
    return PixelRays(camera, shrunk(options.width), shrunk(options.height));
}

/// Points that see a larger share of the sky, along `up`, than `most_sky` do not count.
Preview preview_of(const Scene& scene, const std::vector<Rgb>& radiosity, const PixelRays& rays, Vec3 up, int threads,
                   double most_sky)
{
    constexpr int block = 4; // pixels along a side, which are outdoors or not like one of them
    const std::vector<std::optional<Hit>> hits = visible_hits(scene, rays, threads);
    const int row = rays.width() / block + 1; // blocks
    Preview preview;
    std::vector<std::optional<bool>> outdoors(pixel_index(row, 0, rays.height() / block + 1)); // per block
    RayFan fan;
    for (int y = 0; y < rays.height(); ++y)
        for (int x = 0; x < rays.width(); ++x) {
            const std::optional<Hit>& hit = hits[pixel_index(rays.width(), x, y)];
            if (!hit || scene.is_sky(hit->surface))
                continue;
            std::optional<bool>& is_outdoors = outdoors[pixel_index(row, x / block, y / block)];
            if (!is_outdoors)
                is_outdoors = most_sky < 1.0 && sky_share(scene, gather_point(scene, *hit), up, fan) > most_sky;
            if (*is_outdoors)
                continue;
            const std::uint32_t patch = scene.patch_at(hit->surface, hit->u, hit->v, hit->front);
            if (radiosity[patch] == Rgb{})
                continue;
            preview.all.push_back(radiosity[patch]);
            if (scene.emittance(patch) == Rgb{})
                preview.lit.push_back(radiosity[patch]);
        }
    preview.shows_little = 20 * preview.all.size() < hits.size();
    return preview;
}

} // namespace

double automatic_exposure(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera,
                          const RenderOptions& options, ToneOperator tone)
{
    constexpr double all = 1.0;
    const PixelRays rays = preview_rays(camera, options);
    const Vec3 up = normalized(camera.up);
    double most_sky = all;
    if (scene.file().sky_surfaces > 0 || scene.file().sun) {
        RayFan fan;
        most_sky = sky_share(scene, {GatherPoint::free, camera.eye, up}, up, fan) + much_more;
    }
    Preview preview = preview_of(scene, radiosity, rays, up, options.threads, most_sky);
    if (most_sky < all && preview.shows_little) // the camera looks out of a window
        preview = preview_of(scene, radiosity, rays, up, options.threads, all);
    const double scale = automatic_scale(preview.all, tone);
    return std::min(scale, largest_scale(preview.lit, tone, most_white));
}

} // namespace multipath
