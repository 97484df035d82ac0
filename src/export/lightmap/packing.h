#pragma once

#include "export/lightmap/charts.h"
#include "scene/texture/texture.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

constexpr std::uint32_t chart_margin = 2; ///< [texel] on each side of a chart

/// The lower left corner of a rectangle in the atlas [texel].
struct AtlasPosition
{
    std::uint32_t x = 0;
    std::uint32_t y = 0;
};

/// The positions of the charts in an atlas.
struct AtlasPacking
{
    std::uint32_t size = 0; ///< [texel]
    double scale = 0.0;     ///< [texel / scene unit]
    std::vector<AtlasPosition> positions;
};

/// Packs the charts at the largest scale that bisection finds; nothing if they do not fit even at their minimum sizes.
/// The bounding rectangles of the charts, tallest first, are each placed in the first row with room for it (first-fit
/// decreasing height, Coffman et al. 1980).
std::optional<AtlasPacking> packed(const std::vector<Chart>& charts, std::uint32_t size);

/// Texture frame of a surface whose chart lies at a position of the atlas. Edges of charts run through texel centres
/// where possible, so that bilinear lookup on an edge finds the light of that edge.
TextureFrame atlas_frame(const Surface& surface, const Chart& chart, AtlasPosition position,
                         const AtlasPacking& packing);

} // namespace multipath
