#include "export/lightmap/painting.h"

#include "export/lightmap/packing.h"
#include "export/lightmap/square_corners.h"
#include "geometry/bounds.h"
#include "parallel/blocks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace multipath {

namespace {

/// The point of a surface nearest to a query point.
struct NearestPoint
{
    double u = 0.0;
    double v = 0.0;
    double distance2 = 0.0; ///< [texel^2] squared distance to the query point
};

/// A side of a surface as a polygon in the atlas, in texels from the lower left corner of the atlas.
class AtlasSide
{
public:
    AtlasSide(Shape shape, const TextureFrame& frame, std::uint32_t size)
        : shape_(shape),
          origin_(scaled(frame.origin, size)),
          along_u_(scaled(frame.along_u, size)),
          along_v_(scaled(frame.along_v, size)),
          determinant_(cross(along_u_, along_v_).z)
    {
    }

    Bounds bounds() const { return Surface{shape_, origin_, along_u_, along_v_}.bounds(); }

    NearestPoint nearest(double x, double y) const
    {
        const Vec3 p = Vec3{x, y, 0.0} - origin_;
        const double u = cross(p, along_v_).z / determinant_;
        const double v = cross(along_u_, p).z / determinant_;
        if (u >= 0.0 && v >= 0.0 && (shape_ == Shape::triangle ? u + v <= 1.0 : u <= 1.0 && v <= 1.0))
            return {u, v, 0.0};

        NearestPoint best{0.0, 0.0, std::numeric_limits<double>::infinity()};
        const SquareCorners& corners = square_corners(shape_);
        for (std::size_t k = 0; k < corners.count; ++k) {
            const auto& a = corners.uv[k];
            const auto& b = corners.uv[(k + 1) % corners.count];
            const std::array<double, 2> step = {b[0] - a[0], b[1] - a[1]};
            const Vec3 from = a[0] * along_u_ + a[1] * along_v_;
            const Vec3 edge = step[0] * along_u_ + step[1] * along_v_;
            const double share = std::clamp(dot(p - from, edge) / dot(edge, edge), 0.0, 1.0);
            const Vec3 miss = p - from - share * edge;
            if (dot(miss, miss) < best.distance2)
                best = {a[0] + share * step[0], a[1] + share * step[1], dot(miss, miss)};
        }
        return best;
    }

private:
    static Vec3 scaled(TexturePoint p, std::uint32_t size) { return {p.s * size, p.t * size, 0.0}; }

    Shape shape_;
    Vec3 origin_;
    Vec3 along_u_;
    Vec3 along_v_;
    double determinant_;
};

/// A row of texels that a side reaches, from the bottom of the atlas up.
struct SideRow
{
    std::uint32_t side = 0; ///< index of a frame
    std::uint32_t y = 0;
};

/// Computes the texels of a lightmap whose frames are known. The rectangles of the sides and their margins do not
/// overlap.
class AtlasPainter
{
public:
    AtlasPainter(const Scene& scene, Lightmap& map, const SurfaceLight& light) : scene_(scene), map_(map), light_(light)
    {
    }

    std::vector<SideRow> rows() const
    {
        std::vector<SideRow> rows;
        for (std::uint32_t side = 0; side < map_.frames.size(); ++side) {
            const Bounds box = side_of(side).bounds();
            for (std::uint32_t y = first_texel(box.low.y); y <= last_texel(box.high.y); ++y)
                rows.push_back({side, y});
        }
        return rows;
    }

    void paint(SideRow row)
    {
        // [texel^2] Squared distance to the corner of the margin; a chart may end anywhere in its last texel.
        constexpr double reach2 = 2.0 * (chart_margin + 1) * (chart_margin + 1);
        const AtlasSide side = side_of(row.side);
        const Bounds box = side.bounds();
        const std::size_t above = map_.height - 1 - row.y; // the picture is stored from the top
        for (std::uint32_t x = first_texel(box.low.x); x <= last_texel(box.high.x); ++x)
            if (side.nearest(x + 0.5, row.y + 0.5).distance2 <= reach2)
                map_.texels[above * map_.width + x] = mean_light(side, row, x);
    }

private:
    static std::uint32_t first_texel(double low) { return static_cast<std::uint32_t>(low - chart_margin); }
    static std::uint32_t last_texel(double high) { return static_cast<std::uint32_t>(high + chart_margin); }

    std::uint32_t surface_of(std::uint32_t side) const { return side % scene_.own_surfaces(); }
    AtlasSide side_of(std::uint32_t number) const
    {
        return {scene_.surfaces()[surface_of(number)].shape, map_.frames[number], map_.width};
    }

    /// [W/m^2] Light of a texel: one sample at its centre, or the mean of a grid of samples on a textured surface.
    Rgb mean_light(const AtlasSide& side, SideRow row, std::uint32_t x) const
    {
        constexpr std::uint32_t texture_samples = 4; // in each direction
        const std::uint32_t surface = surface_of(row.side);
        const std::uint32_t samples = scene_.is_textured(surface) ? texture_samples : 1;
        Rgb sum;
        for (std::uint32_t j = 0; j < samples; ++j)
            for (std::uint32_t i = 0; i < samples; ++i) {
                const NearestPoint point = side.nearest(x + (i + 0.5) / samples, row.y + (j + 0.5) / samples);
                sum += light_(surface, row.side < scene_.own_surfaces(), point.u, point.v);
            }
        return 1.0 / (samples * samples) * sum;
    }

    const Scene& scene_;
    Lightmap& map_;
    const SurfaceLight& light_;
};

} // namespace

void paint(Lightmap& map, const Scene& scene, const SurfaceLight& light, int threads)
{
    AtlasPainter painter(scene, map, light);
    const std::vector<SideRow> rows = painter.rows();
    parallel_blocks(rows.size(), threads, [&](std::uint64_t n) { painter.paint(rows[n]); });
}

} // namespace multipath
