#include "export/lightmap/packing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>

namespace multipath {

namespace {

/// Extent of a chart in the atlas along one axis.
struct ChartExtent
{
    double scale = 0.0;       ///< [texel / scene unit]
    std::uint32_t texels = 0; ///< including margins
};

/// Extent of a chart of this length [scene units]. Its edges lie on texel centres at least one texel apart, so that a
/// shorter chart is stretched and covers two texels.
ChartExtent chart_extent(double length, double scale)
{
    constexpr double rounding = 1e-9;
    const double stretched = std::max(scale, 1.0 / length);
    const double steps = std::ceil(stretched * length - rounding);
    return {stretched, static_cast<std::uint32_t>(std::max(1.0, steps)) + 1 + 2 * chart_margin};
}

/// Skyline of a square: the upper outline of the rectangles placed so far.
class AtlasSkyline
{
public:
    explicit AtlasSkyline(std::uint32_t size) : size_(size), steps_({{0, 0, size}}) {}

    /// Places a rectangle at the lowest position, of equal ones at the leftmost; nothing if it does not fit.
    std::optional<AtlasPosition> add(std::uint32_t width, std::uint32_t height)
    {
        std::size_t best = steps_.size();
        std::uint32_t level = size_ - std::min(size_, height) + 1;
        for (std::size_t n = 0; n < steps_.size() && steps_[n].x + width <= size_; ++n)
            if (const std::uint32_t y = level_over(n, width, level); y < level) {
                best = n;
                level = y;
            }
        if (best == steps_.size() || height > size_)
            return std::nullopt;
        const AtlasPosition position = {steps_[best].x, level};
        raise(best, width, level + height);
        return position;
    }

private:
    struct Step
    {
        std::uint32_t x;
        std::uint32_t y;
        std::uint32_t width;
    };

    /// Height of the highest step below a rectangle of this width that starts at step n, or `limit` if that is lower.
    std::uint32_t level_over(std::size_t n, std::uint32_t width, std::uint32_t limit) const
    {
        std::uint32_t y = 0;
        const std::uint32_t end = steps_[n].x + width;
        for (; n < steps_.size() && steps_[n].x < end; ++n) {
            y = std::max(y, steps_[n].y);
            if (y >= limit)
                return limit;
        }
        return y;
    }

    /// Raises the skyline to y over a width that starts at step n.
    void raise(std::size_t n, std::uint32_t width, std::uint32_t y)
    {
        const std::uint32_t x = steps_[n].x;
        const std::uint32_t end = x + width;
        std::size_t past = n;
        while (past < steps_.size() && steps_[past].x + steps_[past].width <= end)
            ++past;
        if (past < steps_.size()) {
            steps_[past].width -= end - std::min(end, std::max(steps_[past].x, x));
            steps_[past].x = std::max(steps_[past].x, end);
        }
        const auto at = [&](std::size_t k) { return steps_.begin() + static_cast<std::ptrdiff_t>(k); };
        steps_.insert(steps_.erase(at(n), at(past)), {x, y, width});
    }

    std::uint32_t size_;
    std::vector<Step> steps_; ///< from left to right, without gaps
};

/// Packs the charts at a given scale; nothing if they do not fit.
std::optional<AtlasPacking> packed_at(const std::vector<Chart>& charts, const std::vector<std::uint32_t>& tallest_first,
                                      std::uint32_t size, double scale)
{
    AtlasPacking packing{size, scale, std::vector<AtlasPosition>(tallest_first.size())};
    AtlasSkyline skyline(size);
    for (const std::uint32_t n : tallest_first) {
        const Chart& chart = charts[n];
        const auto position =
            skyline.add(chart_extent(chart.width, scale).texels, chart_extent(chart.height, scale).texels);
        if (!position)
            return std::nullopt;
        packing.positions[n] = *position;
    }
    return packing;
}

} // namespace

std::optional<AtlasPacking> packed(const std::vector<Chart>& charts, std::uint32_t size)
{
    std::vector<std::uint32_t> tallest_first(charts.size());
    std::iota(tallest_first.begin(), tallest_first.end(), 0u);
    std::stable_sort(tallest_first.begin(), tallest_first.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::tie(charts[a].height, charts[a].width) > std::tie(charts[b].height, charts[b].width);
    });
    std::optional<AtlasPacking> best = packed_at(charts, tallest_first, size, 0.0);
    if (!best)
        return best;

    double area = 0.0;
    double longest = 0.0;
    for (const std::uint32_t n : tallest_first) {
        area += charts[n].width * charts[n].height;
        longest = std::max(longest, charts[n].width);
    }
    double too_large = std::min(size / std::sqrt(area), size / longest);
    constexpr int steps = 12;
    for (int step = 0; step < steps; ++step) {
        const double scale = 0.5 * (best->scale + too_large);
        if (auto packing = packed_at(charts, tallest_first, size, scale))
            best = std::move(packing);
        else
            too_large = scale;
    }
    return best;
}

TextureFrame atlas_frame(const Surface& surface, const Chart& chart, AtlasPosition position,
                         const AtlasPacking& packing)
{
    const double across = chart_extent(chart.width, packing.scale).scale;
    const double up = chart_extent(chart.height, packing.scale).scale;
    const auto direction = [&](Vec3 d) {
        return TexturePoint{across * dot(d, chart.along_x) / packing.size, up * dot(d, chart.along_y) / packing.size};
    };
    constexpr double to_middle = chart_margin + 0.5;
    const TexturePoint origin = direction(surface.origin - chart.corner);
    return {{origin.s + (position.x + to_middle) / packing.size, origin.t + (position.y + to_middle) / packing.size},
            direction(surface.edge_u),
            direction(surface.edge_v),
            true};
}

} // namespace multipath
