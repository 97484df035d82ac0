// A sample of irradiance is the mean of the reflected radiosities where cosine-distributed rays end: the cosine and the
// 1 / pi of the radiance cancel against the density of the rays. The irradiance cache interpolates samples with weights
// that decrease with Ward's estimate of the error at another point,
//
//   error ~ distance to the sample / harmonic mean distance of the surfaces it sees + sqrt(1 - cosine of the normals),
//
// where the distance normal to the surface counts more. Samples of every second row and column within a large square
// are used if they have enough weight, otherwise all samples within a small one.

#include "image/gather/indirect_light.h"

#include "base/mix_bits.h"
#include "geometry/intersector/intersector.h"
#include "image/image.h"
#include "sampling/random.h"
#include "sampling/warp.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

/// [W/m^2] Radiosity without emittance.
std::vector<Rgb> reflected_part(const Scene& scene, const std::vector<Rgb>& radiosity)
{
    std::vector<Rgb> reflected = radiosity;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        reflected[i] =
            by_channel([](double b, double e) { return std::max(0.0, b - e); }, radiosity[i], scene.emittance(i));
    return reflected;
}

} // namespace

IndirectLight::IndirectLight(const Scene& scene, const std::vector<Rgb>& radiosity, int rays, int threads,
                             const SourceLight* near)
    : scene_(scene),
      near_(near),
      rays_(static_cast<std::size_t>(rays)),
      reflected_light_(scene, reflected_part(scene, radiosity), threads)
{
}

namespace {

/// A surface at a point in free space, with its normal: gives axes for the hemisphere there.
Surface facing(const GatherPoint& receiver)
{
    const Vec3 aside = std::abs(receiver.normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 edge = normalized(cross(receiver.normal, aside));
    return {Shape::parallelogram, receiver.point, edge, cross(receiver.normal, edge)};
}

} // namespace

/// True if light is to be gathered anew where a ray has ended.
bool IndirectLight::is_near(const Hit& hit) const
{
    return near_ && !scene_.is_sky(hit.surface) &&
           hit.t * hit.t < scene_.area(scene_.patch_at(hit.surface, hit.u, hit.v, hit.front));
}

/// [W/m^2] Estimate of the radiosity without emittance at a point: the reflected light of a few shadow rays and of one
/// ray over the hemisphere, whose direction is given by the last two numbers of `item`. The radiosity where this ray
/// ends is found in the same way if the ray is again short. `bits`: random.
Rgb IndirectLight::reflected_at(Hit hit, const Sequence& sequence, const Item& item, std::uint64_t bits,
                                RayFan& fan) const
{
    constexpr std::uint64_t shadow_rays = 4; // a power of two: so many consecutive items are stratified
    constexpr int most_reflections = 8;
    double a = item[2];
    double b = item[3];
    Rgb result;
    Rgb reflectance = {1.0, 1.0, 1.0}; // of all points so far
    for (int reflection = 1;; ++reflection) {
        const GatherPoint receiver = gather_point(scene_, hit);
        reflectance = reflectance * scene_.reflectance_at(hit.surface, hit.u, hit.v);
        const SourceLight::Items items{sequence, shadow_rays * (bits >> 14), shadow_rays};
        result += reflectance * near_->irradiance(receiver, items, bits_to_unit(bits), fan);
        const ObliqueAxes axes(scene_.surfaces()[hit.surface], receiver.normal);
        fan.rays = {{receiver.point, axes.turned(square_to_cosine_hemisphere(a, b))}};
        const FirstHits& hits = fan.trace(scene_, hit.surface);
        if (!hits.is_hit(0) || (!hits[0].front && !scene_.two_sided()))
            return result;
        hit = hits[0];
        if (reflection == most_reflections || !is_near(hit))
            return result + reflectance * reflected_light_.at(hit);
        bits = mix_bits(bits + 1);
        a = bits_to_unit(random_bits(bits, 0));
        b = bits_to_unit(random_bits(bits, 1));
    }
}

IndirectSample IndirectLight::at(const GatherPoint& receiver, const Sequence& sequence, std::uint64_t number,
                                 RayFan& fan) const
{
    if (rays_ == 0)
        return {receiver, {}, 0.0};
    fan.items.resize(rays_);
    sequence.generate(number * rays_, fan.items);
    const ObliqueAxes axes(receiver.surface == GatherPoint::free ? facing(receiver)
                                                                 : scene_.surfaces()[receiver.surface],
                           receiver.normal);
    fan.rays.clear();
    for (const Item& item : fan.items)
        fan.rays.push_back({receiver.point, axes.turned(square_to_cosine_hemisphere(item[0], item[1]))});
    const FirstHits& hits = fan.trace(scene_, receiver.surface);
    Rgb sum;
    double nearness = 1.0 / scene_.bounds().diagonal();
    RayFan further;
    for (std::size_t k = 0; k < hits.size(); ++k) {
        if (!hits.is_hit(k))
            continue;
        const Hit hit = hits[k];
        nearness += 1.0 / hit.t;
        if (!hit.front && !scene_.two_sided())
            continue;
        sum += is_near(hit) ? reflected_at(hit, sequence, fan.items[k], mix_bits(number * rays_ + k + 1), further)
                            : reflected_light_.at(hit);
    }
    const auto count = static_cast<double>(fan.items.size());
    return {receiver, 1.0 / count * sum, count / nearness};
}

Rgb IndirectLight::irradiance(const GatherPoint& receiver, const SourceLight& sources, std::uint64_t bits) const
{
    const std::unique_ptr<Sequence> to_sources = make_sequence("sobol-owen", bits);
    const std::unique_ptr<Sequence> around = make_sequence("sobol-owen", ~bits);
    RayFan fan;
    const Rgb direct = sources.irradiance(receiver, {*to_sources, 0, rays_}, bits_to_unit(bits), fan);
    return direct + at(receiver, *around, 0, fan).irradiance;
}

namespace {

// At least 49 pixels are averaged, which hides the noise of a few dozen rays per sample.
constexpr int near_reach = 3;            // [pixels] for samples of all pixels
constexpr int far_reach = 7;             // [pixels] for samples of every second row and column
constexpr double error_tolerance = 0.25; // estimated error at which the weight of a sample becomes 0
constexpr double support = 0.75;         // mean weight of the far samples that makes the near ones unnecessary
constexpr double steepness = 4.0;        // weight of the distance normal to the surface

/// Weight of a sample at a point: falls linearly from 1 at the sample to 0 where the estimated error is the tolerance.
double weight(const IndirectSample& sample, const GatherPoint& receiver)
{
    const Vec3 way = receiver.point - sample.receiver.point;
    const double turn = std::sqrt(std::max(0.0, 1.0 - dot(receiver.normal, sample.receiver.normal)));
    if (!(turn < error_tolerance))
        return 0.0;
    const double step = length(way) + steepness * std::abs(dot(way, sample.receiver.normal));
    return std::max(0.0, 1.0 - (step / sample.distance + turn) / error_tolerance);
}

} // namespace

IndirectGrid::IndirectGrid(int width, int height)
    : width_(width), height_(height), samples_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
{
}

void IndirectGrid::set(int x, int y, const IndirectSample& sample)
{
    samples_[pixel_index(width_, x, y)] = sample;
}

std::optional<Rgb> IndirectGrid::irradiance(const GatherPoint& receiver, int x, int y) const
{
    const Shared far = shared(receiver, x, y, far_reach, 2);
    const Shared found = far.is_enough() ? far : shared(receiver, x, y, near_reach, 1);
    return found.weights > 0.0 ? std::optional<Rgb>((1.0 / found.weights) * found.irradiance) : std::nullopt;
}

bool IndirectGrid::is_supported(const GatherPoint& receiver, int x, int y) const
{
    return shared(receiver, x, y, far_reach, 2).is_enough();
}

bool IndirectGrid::Shared::is_enough() const
{
    return weights >= support * pixels;
}

/// Weighted sum over the samples in every `spacing`-th row and column within `reach`.
IndirectGrid::Shared IndirectGrid::shared(const GatherPoint& receiver, int x, int y, int reach, int spacing) const
{
    const auto first = [&](int middle) {
        const int begin = std::max(0, middle - reach);
        return begin + begin % spacing;
    };
    Shared sum;
    for (int row = first(y); row <= std::min(height_ - 1, y + reach); row += spacing)
        for (int column = first(x); column <= std::min(width_ - 1, x + reach); column += spacing) {
            const IndirectSample& sample = samples_[pixel_index(width_, column, row)];
            const double w = sample.distance > 0.0 ? weight(sample, receiver) : 0.0;
            sum.irradiance += w * sample.irradiance;
            sum.weights += w;
            ++sum.pixels;
        }
    return sum;
}

} // namespace multipath
