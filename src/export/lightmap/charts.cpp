#include "export/lightmap/charts.h"

#include "export/mesh/point_grid.h"
#include "geometry/bounds.h"
#include "geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace multipath {

namespace {

constexpr double same_place = 1e-6; ///< share of the scene's diagonal; points at most this far apart coincide

/// A directed edge between two welded corners as one number.
std::uint64_t edge_key(std::uint32_t from, std::uint32_t to)
{
    return std::uint64_t{from} << 32 | to;
}

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
    std::vector<Chart> charts()
    {
        std::vector<double> areas;
        for (std::uint32_t s = 0; s < scene_.own_surfaces(); ++s)
            areas.push_back(scene_.surfaces()[s].area());
        std::vector<std::uint32_t> order(areas.size());
        std::iota(order.begin(), order.end(), 0u);
        std::stable_sort(order.begin(), order.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return areas[a] > areas[b]; });
        std::vector<Chart> charts;
        for (const std::uint32_t s : order)
            if (chart_[s] == no_chart)
                charts.push_back(flooded(s, static_cast<std::uint32_t>(charts.size())));
        return charts;
    }

private:
    void find_edges()
    {
        constexpr double cell = 64.0; // in tolerances; most searches visit a single cell
        PointGrid grid(cell * tolerance_, 0);
        std::vector<Vec3> points; // the distinct corners
        const auto position = [&](std::uint32_t number) { return points[number]; };
        for (std::uint32_t s = 0; s < scene_.own_surfaces(); ++s) {
            first_corner_.push_back(number_.size());
            for (const Vec3 corner : corners_of(scene_.surfaces()[s])) {
                const auto known = grid.first_near(corner, tolerance_, position);
                number_.push_back(known ? *known : static_cast<std::uint32_t>(points.size()));
                if (!known) {
                    grid.insert(corner, number_.back());
                    points.push_back(corner);
                }
            }
        }
        first_corner_.push_back(number_.size());

        for (std::uint32_t s = 0; s < scene_.own_surfaces(); ++s)
            for_each_edge(s, [&](std::uint32_t from, std::uint32_t to) { edges_.emplace_back(edge_key(from, to), s); });
        std::sort(edges_.begin(), edges_.end());
    }

    /// Calls visit(from, to) for the edges of a surface, counter-clockwise seen from the front.
    template <class Visit>
    void for_each_edge(std::uint32_t surface, const Visit& visit) const
    {
        const std::size_t begin = first_corner_[surface];
        const std::size_t end = first_corner_[surface + 1];
        for (std::size_t n = begin; n < end; ++n)
            visit(number_[n], number_[n + 1 < end ? n + 1 : begin]);
    }

    /// Flood fill from `seed` for chart `number`.
    Chart flooded(std::uint32_t seed, std::uint32_t number)
    {
        Chart chart;
        const Vec3 normal = scene_.surfaces()[seed].normal();
        const auto take = [&](std::uint32_t s) {
            chart_[s] = number;
            chart.surfaces.push_back(s);
        };
        take(seed);
        for (std::size_t next = 0; next < chart.surfaces.size(); ++next)
            for_each_edge(chart.surfaces[next], [&](std::uint32_t from, std::uint32_t to) {
                if (const auto neighbour = coplanar_neighbour(edge_key(to, from), seed, normal))
                    take(*neighbour);
            });
        lay_axes(chart, normal);
        return chart;
    }

    /// A surface without a chart that has this edge and lies in the plane of `seed`. Nothing if the chart of `seed`
    /// already has a surface with this edge, since the two would overlap.
    std::optional<std::uint32_t> coplanar_neighbour(std::uint64_t edge, std::uint32_t seed, Vec3 normal) const
    {
        std::optional<std::uint32_t> found;
        for (auto beyond = std::lower_bound(edges_.begin(), edges_.end(), std::pair(edge, 0u));
             beyond != edges_.end() && beyond->first == edge; ++beyond) {
            const std::uint32_t s = beyond->second;
            if (chart_[s] == chart_[seed])
                return std::nullopt;
            if (!found && chart_[s] == no_chart && is_coplanar(s, seed, normal))
                found = s;
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
        for (const Vec3 corner : corners_of(surface))
            if (std::abs(dot(corner - origin, normal)) > tolerance_)
                return false;
        return true;
    }

    /// Sets axes and rectangle of a chart. One axis is parallel to the longest edge of the seed, and x is that along
    /// which the rectangle is longer.
    void lay_axes(Chart& chart, Vec3 normal) const
    {
        const Surface& largest = scene_.surfaces()[chart.surfaces.front()];
        Vec3 longest = largest.edge_u;
        if (length(largest.edge_v) > length(longest))
            longest = largest.edge_v;
        if (largest.shape == Shape::triangle && length(largest.edge_v - largest.edge_u) > length(longest))
            longest = largest.edge_v - largest.edge_u;
        chart.along_x = normalized(longest);
        chart.along_y = normalized(cross(normal, chart.along_x));

        Bounds box; // in chart coordinates
        for (const std::uint32_t s : chart.surfaces)
            for (const Vec3 corner : corners_of(scene_.surfaces()[s])) {
                const Vec3 p = corner - largest.origin;
                box.include(Vec3{dot(p, chart.along_x), dot(p, chart.along_y), 0.0});
            }
        chart.corner = largest.origin + box.low.x * chart.along_x + box.low.y * chart.along_y;
        chart.width = box.size().x;
        chart.height = box.size().y;
        if (chart.width < chart.height) {
            chart.corner = chart.corner + chart.width * chart.along_x;
            chart.along_x = std::exchange(chart.along_y, -chart.along_x);
            std::swap(chart.width, chart.height);
        }
    }

    static constexpr std::uint32_t no_chart = 0xffffffffu;

    const Scene& scene_;
    double tolerance_;                                           ///< [scene units]
    std::vector<std::uint32_t> chart_;                           ///< per surface; no_chart if it has none yet
    std::vector<std::size_t> first_corner_;                      ///< per surface, and one past the end
    std::vector<std::uint32_t> number_;                          ///< per corner: index after welding
    std::vector<std::pair<std::uint64_t, std::uint32_t>> edges_; ///< edge_key() and surface, sorted
};

} // namespace

std::vector<Chart> charts_of(const Scene& scene)
{
    return ChartFinder(scene).charts();
}

} // namespace multipath
