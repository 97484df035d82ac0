#include "export/lightmap/painting.h"

#include "export/lightmap/packing.h"
#include "export/lightmap/square_corners.h"
#include "geometry/bounds.h"
#include "parallel/blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

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

/// Computes the texels of a lightmap whose frames are known.
class AtlasPainter
{
public:
    AtlasPainter(const Scene& scene, Lightmap& map)
        : scene_(scene), map_(map), size_(map.width), owner_(std::size_t{size_} * size_, nobody)
    {
    }

    /// Finds the owner of every texel: the side that contains its centre, or else the nearest one within the margin.
    void find_owners(const std::vector<Chart>& charts, int threads)
    {
        parallel_blocks(map_.chart_count, threads, [&](std::uint64_t n) {
            for (const std::uint32_t side : charts[n].sides)
                claim(side);
        });
    }

    /// Computes the light of all texels.
    void paint(const SurfaceLight& light, int threads)
    {
        parallel_blocks(size_, threads, [&](std::uint64_t row) {
            const auto y = static_cast<std::uint32_t>(row);
            for (std::uint32_t x = 0; x < size_; ++x)
                if (const std::uint32_t number = owner(x, y); number != nobody)
                    texel(x, y) = mean_light(number, x, y, light);
        });
        fill_free_texels();
    }

private:
    static constexpr std::uint32_t nobody = 0xffffffffu;

    // Rows are counted from the bottom, like texture coordinates; the picture is stored from the top.
    std::size_t index(std::uint32_t x, std::uint32_t y) const { return std::size_t{size_ - 1 - y} * size_ + x; }
    std::uint32_t& owner(std::uint32_t x, std::uint32_t y) { return owner_[index(x, y)]; }
    Rgb& texel(std::uint32_t x, std::uint32_t y) { return map_.texels[index(x, y)]; }

    std::uint32_t surface_of(std::uint32_t side) const { return side % scene_.own_surfaces(); }
    AtlasSide side_of(std::uint32_t number) const
    {
        return {scene_.surfaces()[surface_of(number)].shape, map_.frames[number], size_};
    }

    /// Makes a side the owner of the texels in its reach that are nearer to it than to their present owner.
    void claim(std::uint32_t number)
    {
        // [texel^2] Squared distance to the corner of the margin; a chart may end anywhere in its last texel.
        constexpr double reach2 = 2.0 * (chart_margin + 1) * (chart_margin + 1);
        const AtlasSide side = side_of(number);
        const Bounds box = side.bounds();
        const auto texel_at = [](double x) { return static_cast<std::uint32_t>(x); };
        for (std::uint32_t y = texel_at(box.low.y - chart_margin); y <= texel_at(box.high.y + chart_margin); ++y)
            for (std::uint32_t x = texel_at(box.low.x - chart_margin); x <= texel_at(box.high.x + chart_margin); ++x) {
                const double distance2 = side.nearest(x + 0.5, y + 0.5).distance2;
                std::uint32_t& holder = owner(x, y);
                if (distance2 <= reach2 &&
                    (holder == nobody || distance2 < side_of(holder).nearest(x + 0.5, y + 0.5).distance2))
                    holder = number;
            }
    }

    /// [W/m^2] Light of a texel: one sample at its centre, or the mean of a grid of samples on a textured surface.
    Rgb mean_light(std::uint32_t number, std::uint32_t x, std::uint32_t y, const SurfaceLight& light) const
    {
        constexpr std::uint32_t texture_samples = 4; // in each direction
        const std::uint32_t surface = surface_of(number);
        const std::uint32_t samples = scene_.is_textured(surface) ? texture_samples : 1;
        const AtlasSide side = side_of(number);
        Rgb sum;
        for (std::uint32_t j = 0; j < samples; ++j)
            for (std::uint32_t i = 0; i < samples; ++i) {
                const NearestPoint point = side.nearest(x + (i + 0.5) / samples, y + (j + 0.5) / samples);
                sum += light(surface, number < scene_.own_surfaces(), point.u, point.v);
            }
        return 1.0 / (samples * samples) * sum;
    }

    /// Sets texels without an owner to the mean of the others, since mipmaps blend them with charts.
    void fill_free_texels()
    {
        Rgb sum;
        std::size_t count = 0;
        for (std::size_t n = 0; n < owner_.size(); ++n)
            if (owner_[n] != nobody) {
                sum += map_.texels[n];
                ++count;
            }
        for (std::size_t n = 0; n < owner_.size(); ++n)
            if (owner_[n] == nobody)
                map_.texels[n] = 1.0 / static_cast<double>(count) * sum;
    }

    const Scene& scene_;
    Lightmap& map_;
    std::uint32_t size_;
    std::vector<std::uint32_t> owner_; ///< per texel: index of a frame, or nobody
};

} // namespace

void paint(Lightmap& map, const Scene& scene, const std::vector<Chart>& charts, const SurfaceLight& light, int threads)
{
    AtlasPainter painter(scene, map);
    painter.find_owners(charts, threads);
    painter.paint(light, threads);
}

} // namespace multipath
