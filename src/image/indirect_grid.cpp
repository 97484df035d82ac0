#include "image/indirect_grid.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

constexpr int reach = 3;           // [pixels] enough to hide the noise of some dozen rays
constexpr double tolerance = 0.25; // relative error accepted where things are close
constexpr double steepness = 4.0;  // a step up or down matters more than one along the surface

/// 1 at the sample, falling to 0 where its value would be wrong by the tolerance.
double weight(const IndirectSample& sample, const Place& place)
{
    const Vec3 way = place.point - sample.place.point;
    const double turn = std::sqrt(std::max(0.0, 1.0 - dot(place.normal, sample.place.normal)));
    const double step = length(way) + steepness * std::abs(dot(way, sample.place.normal));
    return std::max(0.0, 1.0 - (step / sample.distance + turn) / tolerance);
}

} // namespace

IndirectGrid::IndirectGrid(int width, int height)
    : width_(width), height_(height), samples_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
{
}

void IndirectGrid::set(int x, int y, const IndirectSample& sample)
{
    samples_[index(x, y)] = sample;
}

std::optional<Rgb> IndirectGrid::irradiance(const Place& place, int x, int y) const
{
    Rgb sum;
    double weights = 0.0;
    for (int row = std::max(0, y - reach); row <= std::min(height_ - 1, y + reach); ++row)
        for (int column = std::max(0, x - reach); column <= std::min(width_ - 1, x + reach); ++column) {
            const IndirectSample& sample = samples_[index(column, row)];
            const double w = sample.distance > 0.0 ? weight(sample, place) : 0.0;
            sum += w * sample.irradiance;
            weights += w;
        }
    return weights > 0.0 ? std::optional<Rgb>((1.0 / weights) * sum) : std::nullopt;
}

std::size_t IndirectGrid::index(int x, int y) const
{
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
}

} // namespace multipath
