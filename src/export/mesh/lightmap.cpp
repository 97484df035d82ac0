// A lightmap is made in three steps.
// 1. Charts: starting with the largest surface, a flood fill over shared edges collects coplanar surfaces of one
//    material.
// 2. Packing: the bounding rectangles of the charts, tallest first, are placed at the lowest position of a skyline
//    (Jylanki 2010, "A thousand ways to pack the bin", bottom-left heuristic). Bisection finds the largest scale that
//    fits.
// 3. Light: each texel near a surface gets the light at the point of the surface nearest to the centre of the texel.
//    Edges of charts run through texel centres where possible, so that bilinear lookup on an edge finds the light of
//    that edge.

#include "export/mesh/lightmap.h"

#include "base/errors.h"
#include "base/little_endian.h"
#include "base/memory.h"
#include "base/mix_bits.h"
#include "export/csv_text.h"
#include "export/json.h"
#include "parallel/blocks.h"
#include "scene/vertex_weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <unordered_map>

namespace multipath {

namespace {

/// The corners of a surface in its coordinates (u, v), counter-clockwise seen from the front.
struct SquareCorners
{
    std::array<std::array<double, 2>, 4> uv;
    std::size_t count;

    const std::array<double, 2>* begin() const { return uv.data(); }
    const std::array<double, 2>* end() const { return uv.data() + count; }
};

const SquareCorners& square_corners(Shape shape)
{
    static constexpr SquareCorners triangle = {{{{0, 0}, {1, 0}, {0, 1}, {0, 0}}}, 3};
    static constexpr SquareCorners parallelogram = {{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, 4};
    return shape == Shape::triangle ? triangle : parallelogram;
}

// ---------------------------------------------------------------------------------------------------------- charts

/// Surfaces in one plane and their bounding rectangle.
struct Chart
{
    std::size_t first = 0; ///< index in ChartList::surfaces
    std::size_t count = 0;
    Vec3 corner;         ///< lower left corner of the rectangle, seen from the front
    Vec3 along_x;        ///< unit vector along the width
    Vec3 along_y;        ///< unit vector along the height
    double width = 0.0;  ///< [scene units]
    double height = 0.0; ///< [scene units]
};

struct ChartList
{
    std::vector<Chart> charts;
    std::vector<std::uint32_t> surfaces; ///< of all charts, one chart after the other
};

constexpr double same_place = 1e-6; ///< share of the scene's diagonal; points at most this far apart coincide

/// Welds points: gives each point an index, the same for points within a tolerance of each other. The points are stored
/// in a hash table of the cells of a grid.
class NearPoints
{
public:
    explicit NearPoints(double tolerance) : tolerance_(tolerance) {}

    std::uint32_t number_of(Vec3 p)
    {
        std::uint32_t found = static_cast<std::uint32_t>(points_.size());
        const Vec3 margin = {tolerance_, tolerance_, tolerance_};
        const Cell low = cell_of(p - margin);
        const Cell high = cell_of(p + margin);
        for (std::int64_t x = low[0]; x <= high[0]; ++x)
            for (std::int64_t y = low[1]; y <= high[1]; ++y)
                for (std::int64_t z = low[2]; z <= high[2]; ++z) {
                    const auto [begin, end] = cells_.equal_range(key({x, y, z}));
                    for (auto entry = begin; entry != end; ++entry)
                        if (length(points_[entry->second] - p) <= tolerance_)
                            found = std::min(found, entry->second);
                }
        if (found == points_.size()) {
            points_.push_back(p);
            cells_.emplace(key(cell_of(p)), found);
        }
        return found;
    }

private:
    using Cell = std::array<std::int64_t, 3>;

    Cell cell_of(Vec3 p) const
    {
        constexpr double cell_size = 64.0; // in tolerances; most searches visit a single cell
        const auto index = [&](double x) {
            return static_cast<std::int64_t>(std::floor(x / (cell_size * tolerance_)));
        };
        return {index(p.x), index(p.y), index(p.z)};
    }
    static std::uint64_t key(Cell cell)
    {
        std::uint64_t bits = 0;
        for (const std::int64_t n : cell)
            bits = mix_bits(bits ^ static_cast<std::uint64_t>(n));
        return bits;
    }

    double tolerance_;
    std::vector<Vec3> points_;
    std::unordered_multimap<std::uint64_t, std::uint32_t> cells_;
};

/// An edge of a surface, directed counter-clockwise seen from the front.
struct DirectedEdge
{
    std::uint32_t from = 0; ///< indices of welded corners
    std::uint32_t to = 0;
    std::uint32_t surface = 0;

    std::uint64_t key() const { return std::uint64_t{from} << 32 | to; }
    std::uint64_t reverse_key() const { return std::uint64_t{to} << 32 | from; }
};

/// Divides the surfaces of a scene into charts.
class ChartFinder
{
public:
    explicit ChartFinder(const Scene& scene)
        : scene_(scene), tolerance_(same_place * scene.own_bounds().diagonal()), chart_(scene.own_surfaces(), no_chart)
    {
        find_edges();
    }

    /// The charts of all surfaces; that with the largest surface is the first.
    ChartList charts()
    {
        std::vector<double> areas(scene_.own_surfaces());
        for (std::uint32_t s = 0; s < areas.size(); ++s)
            areas[s] = scene_.surfaces()[s].area();
        std::vector<std::uint32_t> order(areas.size());
        std::iota(order.begin(), order.end(), 0u);
        std::stable_sort(order.begin(), order.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return areas[a] > areas[b]; });
        ChartList list;
        list.surfaces.reserve(areas.size());
        for (const std::uint32_t s : order)
            if (chart_[s] == no_chart)
                list.charts.push_back(flooded(s, static_cast<std::uint32_t>(list.charts.size()), list.surfaces));
        return list;
    }

private:
    void find_edges()
    {
        LargeVector<Vec3> corners;
        for (std::uint32_t s = 0; s < scene_.own_surfaces(); ++s) {
            const Surface& surface = scene_.surfaces()[s];
            first_corner_.push_back(corners.size());
            for (const auto& [u, v] : square_corners(surface.shape))
                corners.push_back(surface.at(u, v));
        }
        first_corner_.push_back(corners.size());

        const LargeVector<std::uint32_t> representative = weld(corners);
        NearPoints points(tolerance_);
        number_.resize(corners.size());
        for (std::size_t n = 0; n < corners.size(); ++n)
            number_[n] = representative[n] == n ? points.number_of(corners[n]) : number_[representative[n]];

        for (std::uint32_t s = 0; s < scene_.own_surfaces(); ++s)
            for_each_edge(s, [&](const DirectedEdge& edge) { edges_.push_back(edge); });
        std::sort(edges_.begin(), edges_.end(), [](const DirectedEdge& a, const DirectedEdge& b) {
            return a.key() != b.key() ? a.key() < b.key() : a.surface < b.surface;
        });
    }

    template <class Visit>
    void for_each_edge(std::uint32_t surface, const Visit& visit) const
    {
        const std::size_t begin = first_corner_[surface];
        const std::size_t end = first_corner_[surface + 1];
        for (std::size_t n = begin; n < end; ++n)
            visit(DirectedEdge{number_[n], number_[n + 1 < end ? n + 1 : begin], surface});
    }

    /// Flood fill from `seed`: appends the surfaces of chart `number`.
    Chart flooded(std::uint32_t seed, std::uint32_t number, std::vector<std::uint32_t>& surfaces)
    {
        Chart chart;
        chart.first = surfaces.size();
        const Vec3 normal = scene_.surfaces()[seed].normal();
        const auto take = [&](std::uint32_t s) {
            chart_[s] = number;
            surfaces.push_back(s);
        };
        take(seed);
        for (std::size_t next = chart.first; next < surfaces.size(); ++next)
            for_each_edge(surfaces[next], [&](const DirectedEdge& edge) {
                if (const auto neighbour = coplanar_neighbour(edge, seed, normal))
                    take(*neighbour);
            });
        chart.count = surfaces.size() - chart.first;
        lay_axes(chart, seed, normal, surfaces);
        return chart;
    }

    /// A surface without a chart that lies beyond an edge in the plane of `seed`. Nothing if the chart of `seed`
    /// already has a surface there, since the two would overlap.
    std::optional<std::uint32_t> coplanar_neighbour(const DirectedEdge& edge, std::uint32_t seed, Vec3 normal) const
    {
        std::optional<std::uint32_t> found;
        auto beyond = std::lower_bound(edges_.begin(), edges_.end(), edge.reverse_key(),
                                       [](const DirectedEdge& e, std::uint64_t key) { return e.key() < key; });
        for (; beyond != edges_.end() && beyond->key() == edge.reverse_key(); ++beyond) {
            if (chart_[beyond->surface] == chart_[seed])
                return std::nullopt;
            if (!found && chart_[beyond->surface] == no_chart && is_coplanar(beyond->surface, seed, normal))
                found = beyond->surface;
        }
        return found;
    }

    bool is_coplanar(std::uint32_t s, std::uint32_t seed, Vec3 normal) const
    {
        constexpr double least_cosine = 0.99; // loose: normals of small faces are less exact than their corners
        const std::vector<std::uint32_t>& material = scene_.file().material;
        const Surface& surface = scene_.surfaces()[s];
        const Vec3 origin = scene_.surfaces()[seed].origin;
        if (material[s] != material[seed] || !(dot(surface.normal(), normal) > least_cosine))
            return false;
        for (const auto& [u, v] : square_corners(surface.shape))
            if (std::abs(dot(surface.at(u, v) - origin, normal)) > tolerance_)
                return false;
        return true;
    }

    /// Sets axes and rectangle of a chart. One axis is parallel to the longest edge of the seed, and x is that along
    /// which the rectangle is longer.
    void lay_axes(Chart& chart, std::uint32_t seed, Vec3 normal, const std::vector<std::uint32_t>& surfaces) const
    {
        const Surface& largest = scene_.surfaces()[seed];
        Vec3 longest = largest.edge_u;
        if (length(largest.edge_v) > length(longest))
            longest = largest.edge_v;
        if (largest.shape == Shape::triangle && length(largest.edge_v - largest.edge_u) > length(longest))
            longest = largest.edge_v - largest.edge_u;
        chart.along_x = normalized(longest);
        chart.along_y = normalized(cross(normal, chart.along_x));

        Bounds box; // in chart coordinates
        for (std::size_t n = chart.first; n < chart.first + chart.count; ++n) {
            const Surface& surface = scene_.surfaces()[surfaces[n]];
            for (const auto& [u, v] : square_corners(surface.shape)) {
                const Vec3 p = surface.at(u, v) - largest.origin;
                box.include(Vec3{dot(p, chart.along_x), dot(p, chart.along_y), 0.0});
            }
        }
        chart.corner = largest.origin + box.low.x * chart.along_x + box.low.y * chart.along_y;
        chart.width = box.size().x;
        chart.height = box.size().y;
        if (chart.width < chart.height) {
            chart.corner = chart.corner + chart.width * chart.along_x;
            const Vec3 x = chart.along_x;
            chart.along_x = chart.along_y;
            chart.along_y = -x;
            std::swap(chart.width, chart.height);
        }
    }

    static constexpr std::uint32_t no_chart = 0xffffffffu;

    const Scene& scene_;
    double tolerance_;                      ///< [scene units]
    std::vector<std::uint32_t> chart_;      ///< per surface; no_chart if it has none yet
    std::vector<std::size_t> first_corner_; ///< per surface, and one past the end
    std::vector<std::uint32_t> number_;     ///< per corner: index after welding
    std::vector<DirectedEdge> edges_;       ///< sorted by key
};

// --------------------------------------------------------------------------------------------------------- packing

constexpr std::uint32_t chart_margin = 2; ///< [texel] on each side of a chart

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

/// The lower left corner of a rectangle in the atlas [texel].
struct AtlasPosition
{
    std::uint32_t x = 0;
    std::uint32_t y = 0;
};

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
        if (n + 1 < steps_.size() && steps_[n + 1].y == y) {
            steps_[n].width += steps_[n + 1].width;
            steps_.erase(at(n + 1));
        }
        if (n > 0 && steps_[n - 1].y == y) {
            steps_[n - 1].width += steps_[n].width;
            steps_.erase(at(n));
        }
    }

    std::uint32_t size_;
    std::vector<Step> steps_; ///< from left to right, without gaps
};

/// The positions of the charts in an atlas: the front of chart n at positions[n], its back at positions[charts + n].
struct AtlasPacking
{
    std::uint32_t size = 0; ///< [texel]
    double scale = 0.0;     ///< [texel / scene unit]
    std::vector<AtlasPosition> positions;
};

/// Packs the charts at a given scale; nothing if they do not fit.
std::optional<AtlasPacking> packed_at(const std::vector<Chart>& charts, const std::vector<std::uint32_t>& tallest_first,
                                      std::uint32_t size, double scale)
{
    double area = 0.0;
    for (const std::uint32_t n : tallest_first) {
        const Chart& chart = charts[n % charts.size()];
        area += static_cast<double>(chart_extent(chart.width, scale).texels) * chart_extent(chart.height, scale).texels;
    }
    if (area > static_cast<double>(size) * size)
        return std::nullopt;
    AtlasPacking packing{size, scale, std::vector<AtlasPosition>(tallest_first.size())};
    AtlasSkyline skyline(size);
    for (const std::uint32_t n : tallest_first) {
        const Chart& chart = charts[n % charts.size()];
        const auto position =
            skyline.add(chart_extent(chart.width, scale).texels, chart_extent(chart.height, scale).texels);
        if (!position)
            return std::nullopt;
        packing.positions[n] = *position;
    }
    return packing;
}

/// Packs the charts at the largest scale that bisection finds; nothing if they do not fit even at their minimum sizes.
std::optional<AtlasPacking> packed(const std::vector<Chart>& charts, bool two_sided, std::uint32_t size)
{
    std::vector<std::uint32_t> tallest_first((two_sided ? 2 : 1) * charts.size());
    std::iota(tallest_first.begin(), tallest_first.end(), 0u);
    std::stable_sort(tallest_first.begin(), tallest_first.end(), [&](std::uint32_t a, std::uint32_t b) {
        const Chart& one = charts[a % charts.size()];
        const Chart& other = charts[b % charts.size()];
        return one.height != other.height ? one.height > other.height : one.width > other.width;
    });
    std::optional<AtlasPacking> best = packed_at(charts, tallest_first, size, 0.0);
    if (!best)
        return best;

    double area = 0.0;
    double longest = 0.0;
    for (const std::uint32_t n : tallest_first) {
        area += charts[n % charts.size()].width * charts[n % charts.size()].height;
        longest = std::max(longest, charts[n % charts.size()].width);
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

/// Texture frame of a surface whose chart lies at a position of the atlas.
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

// ----------------------------------------------------------------------------------------------------------- light

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
    double area() const { return (shape_ == Shape::triangle ? 0.5 : 1.0) * std::abs(determinant_); }

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
    void find_owners(const ChartList& list, int threads)
    {
        const auto charts = static_cast<std::uint32_t>(list.charts.size());
        parallel_numbers_by(64, map_.chart_count, threads, [&](std::uint32_t n) {
            const Chart& chart = list.charts[n % charts];
            for (std::size_t k = chart.first; k < chart.first + chart.count; ++k)
                claim(list.surfaces[k] + (n < charts ? 0 : scene_.own_surfaces()));
        });
    }

    /// Computes the light of all texels.
    void paint(const SurfaceLight& light, int threads)
    {
        parallel_numbers_by(8, size_, threads, [&](std::uint32_t y) {
            for (std::uint32_t x = 0; x < size_; ++x)
                if (const std::uint32_t number = owner(x, y); number != nobody)
                    texel(x, y) = mean_light(number, x, y, light);
        });
        fill_free_texels();
    }

private:
    static constexpr std::uint32_t nobody = 0xffffffffu;

    template <class Work>
    static void parallel_numbers_by(std::uint32_t range, std::uint32_t count, int threads, const Work& work)
    {
        parallel_ranges(count, range, threads, [&](std::uint32_t first, std::uint32_t end) {
            for (std::uint32_t n = first; n < end; ++n)
                work(n);
        });
    }

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

/// [1] Share of the atlas that lies on a surface.
double share_on_surfaces(const Scene& scene, const Lightmap& map)
{
    double area = 0.0; // [texel^2]
    for (std::size_t n = 0; n < map.frames.size(); ++n)
        area += AtlasSide(scene.surfaces()[n % scene.own_surfaces()].shape, map.frames[n], map.width).area();
    return area / (static_cast<double>(map.width) * map.height);
}

// ----------------------------------------------------------------------------------------------------------- files

struct LightmapSide
{
    std::uint32_t surface = 0;
    bool front = true;
};

/// The sides with one material.
struct LightmapPart
{
    std::uint32_t material = 0;
    std::vector<LightmapSide> sides;
};

/// The parts of all used materials, in the order of the scene's materials; the front of a surface before its back.
std::vector<LightmapPart> lightmap_parts(const Scene& scene)
{
    std::vector<LightmapPart> parts(scene.materials().size());
    for (std::uint32_t s = 0; s < scene.own_surfaces(); ++s) {
        LightmapPart& part = parts[scene.file().material[s]];
        part.material = scene.file().material[s];
        part.sides.push_back({s, true});
        if (scene.two_sided())
            part.sides.push_back({s, false});
    }
    const auto unused = [](const LightmapPart& part) { return part.sides.empty(); };
    parts.erase(std::remove_if(parts.begin(), parts.end(), unused), parts.end());
    return parts;
}

/// Calls visit(u, v) for the corners of a side, counter-clockwise seen from that side.
template <class Visit>
void for_each_corner(const Scene& scene, LightmapSide side, const Visit& visit)
{
    const SquareCorners& corners = square_corners(scene.surfaces()[side.surface].shape);
    for (std::size_t k = 0; k < corners.count; ++k) {
        const auto& [u, v] = corners.uv[side.front ? k : corners.count - 1 - k];
        visit(u, v);
    }
}

// Constants of glTF.
constexpr std::uint64_t gltf_float = 5126;
constexpr std::uint64_t gltf_unsigned = 5125;
constexpr std::uint64_t gltf_vertices = 34962;
constexpr std::uint64_t gltf_triangles = 34963;
constexpr std::uint64_t gltf_linear = 9729; ///< filter without mipmaps, which would blend charts
constexpr std::uint64_t gltf_clamp = 33071;
constexpr std::uint64_t gltf_repeat = 10497;

/// A buffer view of a GLB: values of one attribute, or vertex indices, part after part.
struct GltfView
{
    std::string bytes;
    std::size_t stride = 0; ///< [byte] per vertex; 0 for indices
};

/// The surfaces as buffer views, accessors and meshes of a GLB.
class LightmapMesh
{
public:
    LightmapMesh(const Scene& scene, const Lightmap& map) : scene_(scene), map_(map)
    {
        for (const LightmapPart& part : lightmap_parts(scene))
            add(part);
    }

    const std::vector<GltfView>& views() const { return views_; }
    const std::vector<JsonObject>& accessors() const { return accessors_; }
    const std::vector<JsonObject>& meshes() const { return meshes_; }
    const std::vector<std::uint32_t>& materials() const { return materials_; } ///< the scene's material of each mesh

private:
    enum View : std::size_t { positions, triangles, atlas_points, texture_points };

    void add(const LightmapPart& part)
    {
        JsonObject attributes;
        attributes.count("POSITION", add_positions(part));
        attributes.count("TEXCOORD_0", add_points(atlas_points, part, [&](LightmapSide side) -> const TextureFrame& {
                             return map_.frame(side.surface, side.front);
                         }));
        if (scene_.materials()[part.material].texture != Material::no_texture)
            attributes.count("TEXCOORD_1", add_points(texture_points, part, [&](LightmapSide side) {
                                 return mesh_texture_frame(scene_, side.surface);
                             }));
        const JsonObject primitive = JsonObject()
                                         .object("attributes", attributes)
                                         .count("indices", add_triangles(part))
                                         .count("material", meshes_.size());
        meshes_.push_back(
            JsonObject().text("name", scene_.materials()[part.material].name).objects("primitives", {primitive}));
        materials_.push_back(part.material);
    }

    std::size_t add_positions(const LightmapPart& part)
    {
        std::vector<double> low(3, std::numeric_limits<double>::infinity());
        std::vector<double> high(3, -std::numeric_limits<double>::infinity());
        const std::size_t before = views_[positions].bytes.size();
        const Vec3 origin = mesh_origin(scene_);
        std::size_t vertices = 0;
        for (const LightmapSide& side : part.sides)
            for_each_corner(scene_, side, [&](double u, double v) {
                const Float3 position = single(scene_.surfaces()[side.surface].at(u, v) - origin);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    append_little_endian(views_[positions].bytes, position[axis]);
                    low[axis] = std::min<double>(low[axis], position[axis]);
                    high[axis] = std::max<double>(high[axis], position[axis]);
                }
                ++vertices;
            });
        const std::size_t number = add_accessor(positions, before, gltf_float, vertices, "VEC3");
        accessors_.back().numbers("min", low).numbers("max", high); // required by the format for positions
        return number;
    }

    /// Adds texture coordinates, in glTF measured from the top.
    template <class FrameOf>
    std::size_t add_points(View view, const LightmapPart& part, const FrameOf& frame_of)
    {
        const std::size_t before = views_[view].bytes.size();
        for (const LightmapSide& side : part.sides)
            for_each_corner(scene_, side, [&](double u, double v) {
                const TexturePoint point = frame_of(side).at(u, v);
                append_little_endian(views_[view].bytes, static_cast<float>(point.s));
                append_little_endian(views_[view].bytes, static_cast<float>(1.0 - point.t));
            });
        return add_accessor(view, before, gltf_float, (views_[view].bytes.size() - before) / views_[view].stride,
                            "VEC2");
    }

    std::size_t add_triangles(const LightmapPart& part)
    {
        const std::size_t before = views_[triangles].bytes.size();
        std::uint32_t first = 0;
        for (const LightmapSide& side : part.sides) {
            const auto corners =
                static_cast<std::uint32_t>(square_corners(scene_.surfaces()[side.surface].shape).count);
            for (std::uint32_t k = 2; k < corners; ++k)
                for (const std::uint32_t corner : {0u, k - 1, k})
                    append_little_endian(views_[triangles].bytes, first + corner);
            first += corners;
        }
        return add_accessor(triangles, before, gltf_unsigned, (views_[triangles].bytes.size() - before) / 4, "SCALAR");
    }

    std::size_t add_accessor(View view, std::size_t offset, std::uint64_t component, std::size_t count,
                             const char* type)
    {
        accessors_.push_back(JsonObject()
                                 .count("bufferView", view)
                                 .count("byteOffset", offset)
                                 .count("componentType", component)
                                 .count("count", count)
                                 .text("type", type));
        return accessors_.size() - 1;
    }

    const Scene& scene_;
    const Lightmap& map_;
    std::vector<GltfView> views_ = {{"", 12}, {"", 0}, {"", 8}, {"", 8}}; ///< indexed by View
    std::vector<JsonObject> accessors_;
    std::vector<JsonObject> meshes_;
    std::vector<std::uint32_t> materials_;
};

/// The binary chunk of a GLB: buffer views and files, each padded to a multiple of four bytes.
class GltfChunk
{
public:
    /// Appends a file and returns the index of its buffer view.
    std::size_t add(const std::string& content)
    {
        views_.push_back(
            JsonObject().count("buffer", 0).count("byteOffset", bytes_.size()).count("byteLength", content.size()));
        bytes_.append(content).append((4 - content.size() % 4) % 4, '\0');
        return views_.size() - 1;
    }
    void add(const GltfView& view)
    {
        add(view.bytes);
        views_.back().count("target", view.stride == 0 ? gltf_triangles : gltf_vertices);
        if (view.stride != 0)
            views_.back().count("byteStride", view.stride);
    }

    const std::string& bytes() const { return bytes_; }
    const std::vector<JsonObject>& views() const { return views_; }

private:
    std::string bytes_;
    std::vector<JsonObject> views_;
};

/// A material that shows the atlas. `texture`: index of the material's own texture in the file, if included.
JsonObject lightmap_material(const Material& material, std::optional<std::size_t> texture)
{
    const auto channels = [](Rgb c) { return std::vector<double>{c.r, c.g, c.b}; };
    JsonObject extras = JsonObject()
                            .numbers("reflectance", channels(material.reflectance))
                            .numbers("emittance", channels(material.emittance));
    if (texture)
        extras.object("texture", JsonObject().count("index", *texture).count("texCoord", 1));
    const JsonObject atlas = JsonObject().count("index", 0).count("texCoord", 0);
    return JsonObject()
        .text("name", material.name)
        .object(
            "pbrMetallicRoughness",
            JsonObject().object("baseColorTexture", atlas).count("metallicFactor", 0).number("roughnessFactor", 1.0))
        .boolean("doubleSided", false)
        .object("extensions", JsonObject().object("KHR_materials_unlit", {}))
        .object("extras", extras);
}

/// Adds images, samplers and textures, first for the atlas, then for the scene's own textures; those of one texture
/// have the same index.
void add_lightmap_images(JsonObject& description, const Scene& scene, const std::string& atlas_png,
                         const std::vector<ImageFile>& images, GltfChunk& chunk)
{
    std::vector<JsonObject> files;
    std::vector<JsonObject> samplers;
    std::vector<JsonObject> textures;
    const auto add = [&](const std::string& name, const std::string& type, const std::string& bytes,
                         const JsonObject& sampler) {
        textures.push_back(JsonObject().count("source", files.size()).count("sampler", files.size()));
        samplers.push_back(sampler);
        files.push_back(JsonObject().text("name", name).text("mimeType", type).count("bufferView", chunk.add(bytes)));
    };
    const auto wrapped = [](std::uint64_t wrap) { return JsonObject().count("wrapS", wrap).count("wrapT", wrap); };
    add("lightmap", "image/png", atlas_png,
        wrapped(gltf_clamp).count("magFilter", gltf_linear).count("minFilter", gltf_linear));
    for (std::size_t k = 0; k < images.size(); ++k) {
        const Texture& texture = *scene.file().textures[k];
        add(texture.name(), images[k].type, images[k].bytes, wrapped(texture.repeats() ? gltf_repeat : gltf_clamp));
    }
    description.objects("images", files).objects("samplers", samplers).objects("textures", textures);
}

/// Bytes of a GLB with these two chunks (glTF 2.0 specification, chapter 4). `path` is for messages. Throws InputError
/// for 4 GB or more.
std::string glb_file(std::string json, const std::string& binary, const std::string& path)
{
    json.append((4 - json.size() % 4) % 4, ' ');
    const std::size_t size = 28 + json.size() + binary.size();
    if (size > std::numeric_limits<std::uint32_t>::max())
        throw InputError(path + ": too much for a GLB, which holds less than 4 GB; expected fewer "
                                "surfaces");
    std::string bytes = "glTF";
    bytes.reserve(size);
    for (const std::size_t word : {std::size_t{2}, size, json.size()})
        append_little_endian(bytes, static_cast<std::uint32_t>(word));
    bytes.append("JSON").append(json);
    append_little_endian(bytes, static_cast<std::uint32_t>(binary.size()));
    return bytes.append("BIN\0", 4).append(binary);
}

/// Appends the `v` and `vt` lines of a corner.
void append_obj_corner(std::string& text, Vec3 p, int digits, TexturePoint texture)
{
    std::array<char, 160> lines{};
    p = p + Vec3{}; // never "-0"
    const int length = std::snprintf(lines.data(), lines.size(), "v %.*g %.*g %.*g\nvt %.7g %.7g\n", digits, p.x,
                                     digits, p.y, digits, p.z, texture.s, texture.t);
    text.append(lines.data(), static_cast<std::size_t>(length));
}

} // namespace

Lightmap lightmap(const Scene& scene, std::uint32_t size, const SurfaceLight& light, int threads,
                  std::uint32_t largest_size)
{
    if (size == 0)
        throw std::invalid_argument("a lightmap without texels");
    const ChartList list = ChartFinder(scene).charts();
    std::optional<AtlasPacking> packing = packed(list.charts, scene.two_sided(), size);
    while (!packing && size <= largest_size / 2) {
        size *= 2;
        packing = packed(list.charts, scene.two_sided(), size);
    }
    if (!packing)
        throw InputError(scene.path() + ": its surfaces do not fit into a lightmap of " + std::to_string(size) + " x " +
                         std::to_string(size) + " texels; expected fewer surfaces");

    Lightmap map;
    map.width = size;
    map.height = size;
    map.texels.resize(std::size_t{size} * size);
    map.chart_count = static_cast<std::uint32_t>(packing->positions.size());
    map.texels_per_unit = packing->scale;
    map.frames.resize((scene.two_sided() ? 2 : 1) * std::size_t{scene.own_surfaces()});
    for (std::size_t n = 0; n < packing->positions.size(); ++n) {
        const Chart& chart = list.charts[n % list.charts.size()];
        const std::size_t first_side = n < list.charts.size() ? 0 : scene.own_surfaces();
        for (std::size_t k = chart.first; k < chart.first + chart.count; ++k) {
            const std::uint32_t s = list.surfaces[k];
            map.frames[first_side + s] = atlas_frame(scene.surfaces()[s], chart, packing->positions[n], *packing);
        }
    }
    map.used_share = share_on_surfaces(scene, map);

    AtlasPainter painter(scene, map);
    painter.find_owners(list, threads);
    painter.paint(light, threads);
    return map;
}

std::string lightmap_glb(const Scene& scene, const Lightmap& map, const std::string& atlas_png, double scale,
                         const std::vector<GlbCamera>& cameras, const std::vector<ImageFile>& images,
                         const std::vector<std::string>& comments, Vec3 up)
{
    const LightmapMesh mesh(scene, map);
    GltfChunk chunk;
    for (const GltfView& view : mesh.views())
        if (!view.bytes.empty()) // only the last can be empty
            chunk.add(view);

    std::vector<JsonObject> materials;
    std::vector<std::string> names;
    for (const std::uint32_t number : mesh.materials()) {
        const Material& material = scene.materials()[number];
        names.push_back(material.name);
        const bool has_image = material.texture < images.size();
        materials.push_back(
            lightmap_material(material, has_image ? std::optional<std::size_t>(1 + material.texture) : std::nullopt));
    }
    const GlbNodes nodes = glb_nodes(scene, names, cameras, up);
    JsonObject description;
    description
        .object("asset", JsonObject()
                             .text("version", "2.0")
                             .text("generator", "multipath")
                             .object("extras", JsonObject().texts("record", comments).number("color_scale", scale)))
        .texts("extensionsUsed", {"KHR_materials_unlit"})
        .count("scene", 0)
        .objects("scenes", {JsonObject().numbers("nodes", nodes.roots)})
        .objects("nodes", nodes.nodes);
    if (!nodes.cameras.empty()) // lists must not be empty
        description.objects("cameras", nodes.cameras);
    description.objects("meshes", mesh.meshes()).objects("materials", materials);
    add_lightmap_images(description, scene, atlas_png, images, chunk);
    description.objects("accessors", mesh.accessors())
        .objects("bufferViews", chunk.views())
        .objects("buffers", {JsonObject().count("byteLength", chunk.bytes().size())});
    return glb_file(description.document(), chunk.bytes(), scene.path());
}

std::string lightmap_obj(const Scene& scene, const Lightmap& map, const std::string& mtl_name,
                         const std::vector<std::string>& comments)
{
    std::string text = comment_lines(comments) + "mtllib " + mtl_name + "\n";
    const int digits = coordinate_digits(scene.own_bounds(), 7);
    std::size_t corner = 0;
    for (const LightmapPart& part : lightmap_parts(scene)) {
        text += "usemtl " + scene.materials()[part.material].name + "\n";
        for (const LightmapSide& side : part.sides) {
            std::string face = "f";
            for_each_corner(scene, side, [&](double u, double v) {
                append_obj_corner(text, scene.surfaces()[side.surface].at(u, v), digits,
                                  map.frame(side.surface, side.front).at(u, v));
                const std::string number = std::to_string(++corner);
                face += " " + number + "/" + number;
            });
            text += face + "\n";
        }
    }
    return text;
}

std::string lightmap_mtl(const Scene& scene, const std::string& png_name)
{
    std::string text;
    for (const LightmapPart& part : lightmap_parts(scene)) // illum 0: constant colour, without lights
        text += "newmtl " + scene.materials()[part.material].name + "\nKa 0 0 0\nKd 1 1 1\nillum 0\nmap_Kd " +
                png_name + "\n";
    return text;
}

} // namespace multipath
