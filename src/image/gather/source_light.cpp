// The irradiance of a point by the surfaces that emit is H = H0 V. The unoccluded irradiance H0 is a sum of Lambert's
// closed form over the sources. The visible share V is estimated with shadow rays, which are distributed among the
// sources in proportion to their unoccluded irradiance, and within a source uniformly over its solid angle, so that the
// weight w of a ray contains only the cosine. V is a ratio estimator, exact if all rays agree:
//
//   V ~ sum of w v / sum of w,   v = 1 if the ray meets the source, 0 if it meets something else
//
// Sources that are certainly fully visible (shaft culling) need no rays.

#include "image/gather/source_light.h"

#include "base/lists.h"
#include "geometry/intersector/intersector.h"
#include "sampling/warp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace multipath {

namespace {

constexpr std::size_t most_surfaces = 1000;              // every test visits all surfaces
constexpr std::size_t most_pairs = std::size_t{1} << 24; // bounds the memory of the cache
constexpr std::uint8_t not_certain = 1;
constexpr std::uint8_t fully_visible = 2;

/// True if all points lie on one side of the plane of the surface, up to `touching` [scene units].
bool on_one_side(const std::vector<Vec3>& points, const Surface& surface, double touching)
{
    double low = 0.0;
    double high = 0.0;
    for (const Vec3& point : points) {
        const double height = dot(point - surface.origin, surface.normal());
        low = std::min(low, height);
        high = std::max(high, height);
    }
    return low >= -touching || high <= touching;
}

/// The half-space of the points p with dot(normal, p) <= offset.
struct HalfSpace
{
    Vec3 normal;
    double offset;
};

/// The sides of the convex hull of a few points: the planes through three of them that have all others behind, up to
/// rounding. A side with more than three corners is found more than once.
std::vector<HalfSpace> hull_sides(const std::vector<Vec3>& points)
{
    constexpr double rounding = 1e-7; // of the extent
    Bounds box;
    for (const Vec3& point : points)
        box.include(point);
    const double extent = box.diagonal();
    std::vector<HalfSpace> sides;
    for (std::size_t a = 0; a < points.size(); ++a)
        for (std::size_t b = 0; b < points.size(); ++b)
            for (std::size_t c = std::max(a, b) + 1; c < points.size(); ++c) {
                const Vec3 across = cross(points[b] - points[a], points[c] - points[a]);
                if (!(length(across) > rounding * extent * extent))
                    continue;
                const HalfSpace side = {normalized(across), dot(normalized(across), points[a])};
                const auto is_behind = [&](const Vec3& p) {
                    return dot(side.normal, p) <= side.offset + rounding * extent;
                };
                if (std::all_of(points.begin(), points.end(), is_behind))
                    sides.push_back(side);
            }
    return sides;
}

/// True if the convex hull of the points certainly reaches no deeper than `overlap` [scene units] behind the plane of
/// one of the sides. A negative `overlap` demands a gap.
bool is_separated(const std::vector<HalfSpace>& sides, const std::vector<Vec3>& points, double overlap)
{
    return std::any_of(sides.begin(), sides.end(), [&](const HalfSpace& side) {
        return std::all_of(points.begin(), points.end(),
                           [&](const Vec3& p) { return dot(side.normal, p) - side.offset >= -overlap; });
    });
}

} // namespace

ShaftVisibility::ShaftVisibility(const Scene& scene, std::size_t targets)
    : scene_(scene),
      targets_(targets),
      touching_(1e-6 * scene.bounds().diagonal()),
      known_(scene.surfaces().size() <= most_surfaces && scene.patch_count() * targets <= most_pairs
                 ? scene.patch_count() * targets
                 : 0)
{
}

bool ShaftVisibility::is_fully_visible(std::uint32_t patch, std::size_t number, std::uint32_t surface) const
{
    if (patch == Scene::no_patch || known_.empty())
        return false;
    // Threads that test the same pair at the same time get the same result, so relaxed atomics suffice.
    std::atomic<std::uint8_t>& known = known_[patch * targets_ + number];
    std::uint8_t state = known.load(std::memory_order_relaxed);
    if (state == 0) {
        state = find(patch, surface) ? fully_visible : not_certain;
        known.store(state, std::memory_order_relaxed);
    }
    return state == fully_visible;
}

bool ShaftVisibility::find(std::uint32_t patch, std::uint32_t target) const
{
    const Surface here = scene_.patch(patch).shape;
    const Surface& there = scene_.surfaces()[target];
    std::vector<Vec3> points = corners_of(here);
    for (const Vec3& corner : corners_of(there))
        points.push_back(corner);
    const std::vector<HalfSpace> sides = hull_sides(points);
    const std::uint32_t own = scene_.surface_of(patch);
    for (std::uint32_t s = 0; s < scene_.surfaces().size(); ++s) {
        if (s == own || s == target)
            continue;
        const Surface& surface = scene_.surfaces()[s];
        const HeightRange level = heights(polygon_of(surface), here.origin, here.normal());
        // A surface flat on the patch, such as the bottom of a box, covers it.
        const bool is_flat = level.within(touching_);
        if (!is_flat && on_one_side(points, surface, touching_))
            continue;
        if (!is_separated(sides, corners_of(surface), is_flat ? -touching_ : touching_))
            return false;
    }
    return true;
}

namespace {

constexpr double most_views = 32.0; // of more sources about that many are sampled per point

/// Projection of a convex polygon onto the unit sphere around a point, as a fan of spherical triangles.
class SeenPolygon
{
public:
    SeenPolygon(const FlatPolygon& polygon, Vec3 point)
    {
        const auto towards = [&](std::size_t k) { return normalized(polygon.corners[k] - point); };
        for (std::size_t k = 1; k + 1 < polygon.size; ++k) {
            triangles_[count_].emplace(towards(0), towards(k), towards(k + 1));
            solid_angle_ += triangles_[count_++]->solid_angle();
        }
    }

    double solid_angle() const { return solid_angle_; }

    /// Direction for two uniform numbers, uniformly distributed over the solid angle, which must not be 0.
    Vec3 direction(double a, double b) const
    {
        double rest = a * solid_angle_;
        std::size_t k = 0;
        for (; k + 1 < count_ && rest >= triangles_[k]->solid_angle(); ++k)
            rest -= triangles_[k]->solid_angle();
        return triangles_[k]->direction(std::min(1.0, rest / triangles_[k]->solid_angle()), b);
    }

private:
    std::array<std::optional<SphericalTriangle>, 3> triangles_;
    std::size_t count_ = 0;
    double solid_angle_ = 0.0;
};

} // namespace

SourceLight::SourceLight(const Scene& scene)
    : scene_(scene), sources_(sources_of(scene)), shafts_(scene, sources_.size())
{
}

std::vector<SourceLight::Source> SourceLight::sources_of(const Scene& scene)
{
    std::vector<Source> sources;
    for (std::uint32_t surface = 0; surface < scene.surfaces().size(); ++surface) {
        const Rgb emittance = scene.surface_material(surface).emittance;
        const Surface& shape = scene.surfaces()[surface];
        const double power = shape.area() * mean(emittance);
        if (!(power > 0.0))
            continue;
        double radius = 0.0;
        for (const Vec3& corner : corners_of(shape))
            radius = std::max(radius, length(corner - shape.centre()));
        sources.push_back({surface, emittance, power, shape.centre(), radius});
    }
    return sources;
}

/// Importance for sampling: roughly proportional to the unoccluded irradiance by the source, namely its power over the
/// squared distance, bounded by its extent. 0 only if the source is entirely below the horizon.
double SourceLight::importance(const Source& source, const GatherPoint& receiver)
{
    const Vec3 way = source.centre - receiver.point;
    if (dot(way, receiver.normal) <= -source.radius)
        return 0.0;
    return source.power / (dot(way, way) + source.radius * source.radius);
}

/// Views of the sources. If there are more than `most_views`, about that many are chosen by systematic sampling, with
/// probabilities in proportion to their importance, and weighted with the inverse probability.
SourceLight::SourceViews SourceLight::source_views(const GatherPoint& receiver, double offset) const
{
    SourceViews result;
    const bool all = static_cast<double>(sources_.size()) <= most_views;
    const auto importance_of = [&](const Source& source) { return importance(source, receiver); };
    const double sum = all ? 0.0 : sum_over(sources_, importance_of);
    if (!all && !(sum > 0.0))
        return result;
    double choices_before = offset;
    for (std::size_t k = 0; k < sources_.size(); ++k) {
        const Source& source = sources_[k];
        double weight = 1.0;
        if (!all) {
            const double choices = importance_of(source) * (most_views / sum);
            const double chosen = std::floor(choices_before + choices) - std::floor(choices_before);
            choices_before += choices;
            weight = chosen > 0.0 ? chosen / choices : 0.0;
        }
        if (!(weight > 0.0))
            continue;
        const FlatPolygon outline =
            part_above_horizon(scene_.surfaces()[source.surface], receiver.point, receiver.normal);
        const double form_factor = outline.empty() ? 0.0 : irradiance_from(outline, receiver.point, receiver.normal);
        if (!(form_factor > 0.0))
            continue;
        const Rgb irradiance = weight * form_factor * source.emittance;
        if (shafts_.is_fully_visible(receiver.patch, k, source.surface))
            result.clear += irradiance;
        else
            result.views.push_back({source.surface, outline, form_factor, irradiance});
    }
    return result;
}

Rgb SourceLight::irradiance(const GatherPoint& receiver, const Items& items, double offset, RayFan& fan) const
{
    const auto [unobstructed, views] = source_views(receiver, offset);
    const Rgb sunlight = scene_.sunlight(receiver.surface, receiver.point, receiver.normal);
    if (views.empty())
        return unobstructed + sunlight;
    fan.items.resize(items.count);
    items.sequence.generate(items.first, fan.items);
    const Rgb unhidden = sum_over(views, &View::irradiance);
    const double per_ray = mean(unhidden) / static_cast<double>(fan.items.size());
    struct Sent
    {
        std::uint32_t source; ///< surface
        Rgb weight;
    };
    std::vector<Sent> sent;
    fan.rays.clear();
    double sum = offset; // cumulative number of rays in proportion to irradiance, before rounding (systematic sampling)
    for (const View& view : views) {
        sum += mean(view.irradiance) / per_ray;
        if (!(static_cast<double>(sent.size()) + 1.0 <= sum))
            continue;
        const SeenPolygon seen(view.outline, receiver.point);
        while (static_cast<double>(sent.size()) + 1.0 <= sum && sent.size() < fan.items.size() &&
               seen.solid_angle() > 0.0) {
            const Item& item = fan.items[sent.size()];
            const Vec3 direction = seen.direction(item[0], item[1]);
            const double cosine = std::max(0.0, dot(direction, receiver.normal));
            sent.push_back({view.surface,
                            cosine * seen.solid_angle() / view.form_factor / mean(view.irradiance) * view.irradiance});
            fan.rays.push_back({receiver.point, direction});
        }
    }
    const FirstHits& hits = fan.trace(scene_, receiver.surface);
    Rgb all;
    Rgb arrived;
    for (std::size_t k = 0; k < sent.size(); ++k) {
        all += sent[k].weight;
        if (hits.is_hit(k) && hits[k].surface == sent[k].source && hits[k].front)
            arrived += sent[k].weight;
    }
    return unobstructed + unhidden * quotient(arrived, all) + sunlight;
}

} // namespace multipath
