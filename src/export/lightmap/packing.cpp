#include "export/lightmap/packing.h"

#include <algorithm>
#include <cmath>
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

/// A row of charts in the atlas.
struct AtlasRow
{
    std::uint32_t y;     ///< [texel]
    std::uint32_t width; ///< [texel] of its charts
};

/// Packs the charts at a given scale; nothing if they do not fit.
std::optional<AtlasPacking> packed_at(const std::vector<Chart>& charts, const std::vector<std::uint32_t>& tallest_first,
                                      std::uint32_t size, double scale)
{
    AtlasPacking packing{size, scale, std::vector<AtlasPosition>(tallest_first.size())};
    std::vector<AtlasRow> rows;
    std::uint32_t top = 0; // of the last row
    for (const std::uint32_t n : tallest_first) {
        const std::uint32_t width = chart_extent(charts[n].width, scale).texels;
        const std::uint32_t height = chart_extent(charts[n].height, scale).texels;
        auto row =
            std::find_if(rows.begin(), rows.end(), [&](const AtlasRow& other) { return other.width + width <= size; });
        if (row == rows.end()) {
            if (width > size || top + height > size)
                return std::nullopt;
            row = rows.insert(row, {top, 0});
            top += height;
        }
        packing.positions[n] = {row->width, row->y};
        row->width += width;
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
