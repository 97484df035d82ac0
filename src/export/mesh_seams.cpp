// Surfaces are cut one by one. Two that share a whole edge are cut alike there, but one wall beside two, or a triangle
// beside a rectangle, are not: a corner of one then lies on an edge of the other, and what is drawn in single precision
// gapes by a fraction of a pixel. So every edge on the rim of a side gets the corners that others have on it.

#include "export/mesh_seams.h"

#include "export/edge_cuts.h"
#include "export/point_grid.h"
#include "geometry/bounds.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace multipath {

namespace {

std::pair<std::uint32_t, std::uint32_t> ends_of(const PatchMesh& mesh, RimEdge edge)
{
    const MeshFace& face = mesh.faces[edge.face];
    return {face.corners[edge.corner], face.corners[(edge.corner + 1) % face.corner_count]};
}

double mean_length(const PatchMesh& mesh)
{
    double sum = 0.0;
    for (const RimEdge edge : mesh.rims) {
        const auto [a, b] = ends_of(mesh, edge);
        sum += length(to_vec3(mesh.positions[b]) - to_vec3(mesh.positions[a]));
    }
    return sum / static_cast<double>(mesh.rims.size());
}

/// Moves the corners on rims to the first one within the tolerance, and returns all such places.
PointGrid join_corners(PatchMesh& mesh, double cell, double tolerance)
{
    PointGrid places(cell, mesh.rim_vertices.size());
    const Vec3 margin = {tolerance, tolerance, tolerance};
    for (const std::uint32_t vertex : mesh.rim_vertices) {
        const Vec3 here = to_vec3(mesh.positions[vertex]);
        std::optional<std::uint32_t> earliest;
        places.visit_box(here - margin, here + margin, [&](std::uint32_t other) {
            if (length(to_vec3(mesh.positions[other]) - here) <= tolerance)
                earliest = earliest ? std::min(*earliest, other) : other;
        });
        if (earliest)
            mesh.positions[vertex] = mesh.positions[*earliest];
        else
            places.insert(here, vertex);
    }
    return places;
}

/// The places inside an edge, from its first corner to its second.
std::vector<EdgeCut> cuts_of(const PatchMesh& mesh, RimEdge edge, const PointGrid& places, double cell,
                             double tolerance)
{
    const auto [first, second] = ends_of(mesh, edge);
    const Vec3 start = to_vec3(mesh.positions[first]);
    const Vec3 along = to_vec3(mesh.positions[second]) - start;
    const double extent = length(along);
    const Vec3 margin = {tolerance, tolerance, tolerance};
    const double steps = std::max(1.0, std::ceil(extent / cell)); // many small boxes: a large one has too many cells
    std::vector<EdgeCut> cuts;
    for (double step = 0.0; step < steps; step += 1.0) {
        Bounds box;
        box.include(start + step / steps * along);
        box.include(start + (step + 1.0) / steps * along);
        places.visit_box(box.low - margin, box.high + margin, [&](std::uint32_t vertex) {
            const Vec3 way = to_vec3(mesh.positions[vertex]) - start;
            const double share = dot(way, along) / (extent * extent);
            const bool inside = share * extent > tolerance && (1.0 - share) * extent > tolerance;
            if (inside && length(way - share * along) <= tolerance)
                cuts.push_back({edge, share, vertex});
        });
    }
    std::sort(cuts.begin(), cuts.end(), [](const EdgeCut& a, const EdgeCut& b) { return a.share < b.share; });
    const auto same = [](const EdgeCut& a, const EdgeCut& b) { return a.vertex == b.vertex; };
    cuts.erase(std::unique(cuts.begin(), cuts.end(), same), cuts.end());
    return cuts;
}

} // namespace

PatchMesh sewn(PatchMesh mesh, double tolerance)
{
    if (mesh.rims.empty())
        return mesh;
    const double cell = std::max(2.0 * mean_length(mesh), tolerance);
    const PointGrid places = join_corners(mesh, cell, tolerance);
    std::vector<EdgeCut> cuts;
    for (const RimEdge edge : mesh.rims) {
        const std::vector<EdgeCut> more = cuts_of(mesh, edge, places, cell, tolerance);
        cuts.insert(cuts.end(), more.begin(), more.end());
    }
    mesh.rims = {};
    mesh.rim_vertices = {};
    return cuts.empty() ? mesh : with_cuts(mesh, cuts);
}

} // namespace multipath
