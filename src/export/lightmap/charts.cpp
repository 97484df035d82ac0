#include "export/lightmap/charts.h"

#include "geometry/bounds.h"
#include "geometry/polygon.h"
#include "scene/surface_edges.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace multipath {

namespace {

constexpr double same_place = 1e-6; ///< share of the scene's diagonal; points at most this far apart coincide

/// Divides the surfaces of a scene into charts.
class ChartFinder
{
public:
    explicit ChartFinder(const Scene& scene)
        : scene_(scene),
          tolerance_(same_place * scene.own_bounds().diagonal()),
          chart_(scene.own_surfaces(), no_chart),
          edges_(edges_of({scene.surfaces().begin(), scene.surfaces().begin() + scene.own_surfaces()},
                          scene.own_bounds())),
          neighbours_(edges_)
    {
        std::stable_sort(neighbours_.begin(), neighbours_.end(), before);
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
    static bool before(const FaceEdge& a, const FaceEdge& b)
    {
        return std::tie(a.low, a.high, a.upward) < std::tie(b.low, b.high, b.upward);
    }

    /// Flood fill from `seed` for chart `number`.
    Chart flooded(std::uint32_t seed, std::uint32_t number)
    {
        Chart chart;
        const Vec3 normal = scene_.surfaces()[seed].normal();
        const auto take = [&](std::uint32_t s) {
            chart_[s] = number;
            chart.sides.push_back(s);
        };
        take(seed);
        for (std::size_t next = 0; next < chart.sides.size(); ++next) {
            const std::uint32_t face = chart.sides[next];
            const auto of_lower_face = [](const FaceEdge& edge, std::uint32_t f) { return edge.face < f; };
            for (auto edge = std::lower_bound(edges_.begin(), edges_.end(), face, of_lower_face);
                 edge != edges_.end() && edge->face == face; ++edge)
                if (const auto neighbour = coplanar_neighbour(*edge, seed, normal))
                    take(*neighbour);
        }
        lay_axes(chart, normal);
        return chart;
    }

    /// A surface without a chart that has this edge in the opposite direction and lies in the plane of `seed`. Nothing
    /// if the chart of `seed` already has a surface with that edge, since the two would overlap.
    std::optional<std::uint32_t> coplanar_neighbour(FaceEdge edge, std::uint32_t seed, Vec3 normal) const
    {
        const FaceEdge wanted = {edge.low, edge.high, 0, !edge.upward};
        const auto [begin, end] = std::equal_range(neighbours_.begin(), neighbours_.end(), wanted, before);
        std::optional<std::uint32_t> found;
        for (auto beyond = begin; beyond != end; ++beyond) {
            const std::uint32_t s = beyond->face;
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
        const Surface& largest = scene_.surfaces()[chart.sides.front()];
        Vec3 longest = largest.edge_u;
        if (length(largest.edge_v) > length(longest))
            longest = largest.edge_v;
        if (largest.shape == Shape::triangle && length(largest.edge_v - largest.edge_u) > length(longest))
            longest = largest.edge_v - largest.edge_u;
        chart.along_x = normalized(longest);
        chart.along_y = normalized(cross(normal, chart.along_x));

        Bounds box; // in chart coordinates
        for (const std::uint32_t s : chart.sides)
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
    double tolerance_;                 ///< [scene units]
    std::vector<std::uint32_t> chart_; ///< per surface; no_chart if it has none yet
    LargeVector<FaceEdge> edges_;      ///< in the order of the surfaces
    LargeVector<FaceEdge> neighbours_; ///< the same, sorted by before()
};

} // namespace

std::vector<Chart> charts_of(const Scene& scene)
{
    std::vector<Chart> charts = ChartFinder(scene).charts();
    for (std::size_t n = 0, fronts = charts.size(); scene.two_sided() && n < fronts; ++n) {
        charts.push_back(Chart(charts[n]));
        for (std::uint32_t& side : charts.back().sides)
            side += scene.own_surfaces();
    }
    return charts;
}

} // namespace multipath
