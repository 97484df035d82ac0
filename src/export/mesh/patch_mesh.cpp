#include "export/mesh/patch_mesh.h"

#include "base/errors.h"
#include "export/mesh/point_grid.h"
#include "geometry/bounds.h"
#include "geometry/intersector/intersector.h"
#include "geometry/polygon.h"
#include "geometry/vec3.h"
#include "parallel/blocks.h"
#include "sampling/random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

namespace multipath {

// The surfaces that lie over a patch are subtracted from the patch until an uncovered point is found or nothing is
// left. The rest of the patch is kept as a list of triangles. The next surface to subtract is one that covers the
// centroid of the first triangle. If no surface covers that centroid, the patch is visible there.

namespace {

constexpr double least_share = 2e-4; ///< share of the patch; smaller triangles result from rounded coordinates in files

double area_of(const FlatPolygon& triangle)
{
    return 0.5 * length(cross(triangle.corners[1] - triangle.corners[0], triangle.corners[2] - triangle.corners[0]));
}

/// Appends the polygon as a fan of triangles, without those of at most `least_area`.
void append_triangles(const FlatPolygon& polygon, double least_area, std::vector<FlatPolygon>& triangles)
{
    for (std::size_t k = 1; k + 1 < polygon.size; ++k) {
        FlatPolygon triangle;
        for (const std::size_t corner : {std::size_t{0}, k, k + 1})
            triangle.add(polygon.corners[corner]);
        if (area_of(triangle) > least_area)
            triangles.push_back(triangle);
    }
}

/// The parts of triangles outside a convex surface in the same plane.
std::vector<FlatPolygon> without(const std::vector<FlatPolygon>& triangles, const Surface& surface, double least_area)
{
    const FlatPolygon cover = polygon_of(surface);
    std::vector<FlatPolygon> outside;
    std::vector<FlatPolygon> inside = triangles;
    for (std::size_t k = 0; k < cover.size; ++k) {
        const Vec3 inward = normalized(cross(surface.normal(), cover.next(k) - cover.corners[k]));
        std::vector<FlatPolygon> still_inside;
        for (const FlatPolygon& triangle : inside) {
            append_triangles(part_in_front(triangle, cover.corners[k], -inward, 0.0), least_area, outside);
            append_triangles(part_in_front(triangle, cover.corners[k], inward, 0.0), least_area, still_inside);
        }
        inside = std::move(still_inside);
    }
    return outside;
}

/// True if `surface` hides the given side of a coplanar patch where they overlap: a ray that arrives at that side meets
/// a visible side of `surface` first.
bool lies_over(const Scene& scene, std::uint32_t surface, const Patch& patch, bool front)
{
    const bool faces_viewer = dot(scene.surfaces()[surface].normal(), patch.shape.normal()) > 0.0;
    if (faces_viewer != front)
        return faces_viewer;
    return front ? scene.intersector().is_over(surface, patch.surface)
                 : scene.two_sided() && scene.intersector().is_over(patch.surface, surface);
}

bool is_covered(const Scene& scene, std::uint32_t number)
{
    const Patch patch = scene.patch(number);
    const bool front = scene.is_front(number);
    const double least_area = least_share * patch.shape.area();
    std::vector<FlatPolygon> left;
    append_triangles(polygon_of(patch.shape), least_area, left);
    std::vector<std::uint32_t> subtracted;
    while (!left.empty()) {
        const FlatPolygon& first = left.front();
        const Vec3 middle = (1.0 / 3.0) * (first.corners[0] + first.corners[1] + first.corners[2]);
        const std::vector<std::uint32_t> there = scene.intersector().coincident_surfaces(patch.surface, middle);
        const auto over = std::find_if(there.begin(), there.end(), [&](std::uint32_t surface) {
            return lies_over(scene, surface, patch, front) &&
                   std::find(subtracted.begin(), subtracted.end(), surface) == subtracted.end();
        });
        if (over == there.end())
            return false;
        left = without(left, scene.surfaces()[*over], least_area);
        subtracted.push_back(*over);
    }
    return true;
}

} // namespace

std::vector<bool> covered_patches(const Scene& scene, int threads)
{
    std::vector<std::uint8_t> covered(scene.patch_count());
    parallel_numbers(scene.patch_count(), threads, [&](std::uint32_t i) { covered[i] = is_covered(scene, i) ? 1 : 0; });
    return {covered.begin(), covered.end()};
}

Vec3 mesh_origin(const Scene& scene)
{
    constexpr double far = 4.0; // diagonals: there floats are still finer than the tolerance of joined corners
    const Bounds box = scene.own_bounds();
    if (box.largest_coordinate() <= far * box.diagonal())
        return {};
    int exponent = 0;
    std::frexp(box.diagonal(), &exponent);
    const double step = std::ldexp(1.0, exponent - 1); // at most the diagonal, so that the point has few digits
    const auto rounded = [&](double x) { return static_cast<double>(static_cast<float>(step * std::round(x / step))); };
    return {rounded(box.centre().x), rounded(box.centre().y), rounded(box.centre().z)};
}

TextureFrame mesh_texture_frame(const Scene& scene, std::uint32_t surface)
{
    constexpr double far = 256.0; // images; nearer, a float is finer than a thirtieth of a pixel of 2048
    TextureFrame frame = scene.file().texture_frames[surface];
    TexturePoint& origin = frame.origin;
    const bool repeats =
        scene.is_textured(surface) && scene.file().textures[scene.surface_material(surface).texture]->repeats();
    if (repeats && std::max(std::abs(origin.s), std::abs(origin.t)) > far)
        origin = {origin.s - std::floor(origin.s), origin.t - std::floor(origin.t)};
    return frame;
}

// Surfaces are tessellated one by one. Two surfaces that share a whole edge have the same corners on it, but a long
// wall beside two short ones, or a triangle beside a rectangle, do not. A corner of one surface then lies on an edge of
// the other (T-junction), and in single precision there are cracks of a fraction of a pixel. The mesh is therefore
// stitched: every edge on the rim of a side gets the corners of other sides that lie on it.

namespace {

constexpr double coinciding = 1e-6; ///< share of the scene's diagonal; corners at most this far apart coincide

/// The edges of the surface on which a point of its grid lies, one bit each.
unsigned rim_of(const Tessellation& cut, GridPoint a)
{
    const bool triangle = cut.shape == Shape::triangle;
    return (a.i == 0 ? 1u : 0u) | (a.j == 0 ? 2u : 0u) | ((triangle ? a.i + a.j : a.i) == cut.grid_u() ? 4u : 0u) |
           (!triangle && a.j == cut.grid_v() ? 8u : 0u);
}

/// An edge of a face on the rim of its side, from one corner of the face to the next.
struct RimEdge
{
    std::uint32_t face = 0;
    std::uint32_t corner = 0; ///< 0 to 3
};

/// The rims of all sides, along which they are stitched.
struct Rims
{
    std::vector<RimEdge> edges;          ///< in the order of the faces
    std::vector<std::uint32_t> vertices; ///< in the order of the vertices
};

/// A T-junction: a corner of another side on an edge of the rim.
struct EdgeCut
{
    RimEdge edge;
    double share = 0.0;       ///< [1] position along the edge, in (0, 1)
    std::uint32_t vertex = 0; ///< vertex of the other side
};

/// A vertex with its weight in an interpolation.
struct VertexWeight
{
    std::uint32_t vertex = 0;
    double weight = 0.0;
};

Float3 interpolated(const std::vector<Float3>& values, const std::vector<VertexWeight>& weights)
{
    Rgb sum;
    for (const VertexWeight& w : weights)
        sum += w.weight * to_rgb(values[w.vertex]);
    return single(sum);
}

/// A copy of a mesh in which every face that has cuts is replaced by a fan of triangles around its centroid, which uses
/// the corners of the other sides. Cuts must be sorted by face, corner and position along the edge. The values [W/m^2]
/// of new vertices are interpolated.
class CutMesh
{
public:
    CutMesh(const PatchMesh& whole, const std::vector<EdgeCut>& cuts) : whole_(whole), cuts_(cuts)
    {
        result_.origin = whole.origin;
        for (const MeshSide& side : whole.sides)
            add_side(side);
    }

    PatchMesh result() && { return std::move(result_); }

private:
    void add_side(const MeshSide& whole)
    {
        MeshSide side = whole;
        side.first_vertex = result_.positions.size();
        side.first_face = result_.faces.size();
        for (auto list : {&PatchMesh::positions, &PatchMesh::radiosity, &PatchMesh::error})
            if (!(whole_.*list).empty()) {
                const auto first = (whole_.*list).begin() + static_cast<std::ptrdiff_t>(whole.first_vertex);
                (result_.*list)
                    .insert((result_.*list).end(), first, first + static_cast<std::ptrdiff_t>(whole.vertex_count));
            }
        shift_ = static_cast<std::uint32_t>(side.first_vertex - whole.first_vertex);
        for (std::size_t face = whole.first_face; face < whole.first_face + whole.face_count; ++face)
            if (next_ < cuts_.size() && cuts_[next_].edge.face == face)
                add_fan(whole_.faces[face], rim_with_cuts(whole_.faces[face], face));
            else
                add_face(whole_.faces[face]);
        side.vertex_count = result_.positions.size() - side.first_vertex;
        side.face_count = result_.faces.size() - side.first_face;
        result_.sides.push_back(side);
    }

    void add_face(MeshFace face)
    {
        for (std::uint32_t& corner : face.corners)
            corner += shift_;
        result_.faces.push_back(face);
    }

    std::uint32_t add_vertex(Float3 position, const std::vector<VertexWeight>& weights)
    {
        result_.positions.push_back(position);
        result_.radiosity.push_back(interpolated(whole_.radiosity, weights));
        if (!whole_.error.empty())
            result_.error.push_back(interpolated(whole_.error, weights));
        return static_cast<std::uint32_t>(result_.positions.size() - 1);
    }

    /// The vertices around a face: its own corners and the cuts on its edges, which are added as vertices.
    std::vector<std::uint32_t> rim_with_cuts(const MeshFace& face, std::size_t number)
    {
        std::vector<std::uint32_t> rim;
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            rim.push_back(face.corners[k] + shift_);
            const std::uint32_t second = face.corners[(k + 1) % face.corner_count];
            for (; next_ < cuts_.size() && cuts_[next_].edge.face == number && cuts_[next_].edge.corner == k; ++next_) {
                const EdgeCut& cut = cuts_[next_];
                rim.push_back(add_vertex(whole_.positions[cut.vertex],
                                         {{face.corners[k], 1.0 - cut.share}, {second, cut.share}}));
            }
        }
        return rim;
    }

    /// Adds a fan of triangles around the centroid of a face: none of them is degenerate, wherever the cuts are.
    void add_fan(const MeshFace& face, const std::vector<std::uint32_t>& rim)
    {
        std::vector<VertexWeight> corners;
        for (const std::uint32_t corner : face)
            corners.push_back({corner, 1.0 / face.corner_count});
        const std::uint32_t middle = add_vertex(interpolated(whole_.positions, corners), corners);
        for (std::size_t n = 0; n < rim.size(); ++n)
            result_.faces.push_back({{middle, rim[n], rim[(n + 1) % rim.size()], 0}, 3, face.patch});
    }

    const PatchMesh& whole_;
    const std::vector<EdgeCut>& cuts_;
    std::size_t next_ = 0;    ///< index of the next cut
    std::uint32_t shift_ = 0; ///< from old indices of the side's vertices to new ones
    PatchMesh result_;
};

std::pair<std::uint32_t, std::uint32_t> ends_of(const PatchMesh& mesh, RimEdge edge)
{
    const MeshFace& face = mesh.faces[edge.face];
    return {face.corners[edge.corner], face.corners[(edge.corner + 1) % face.corner_count]};
}

double mean_length(const PatchMesh& mesh, const Rims& rims)
{
    double sum = 0.0;
    for (const RimEdge edge : rims.edges) {
        const auto [a, b] = ends_of(mesh, edge);
        sum += length(to_vec3(mesh.positions[b]) - to_vec3(mesh.positions[a]));
    }
    return sum / static_cast<double>(rims.edges.size());
}

/// Welds the vertices on rims: moves each to the first one within the tolerance. Returns the distinct positions.
PointGrid join_corners(PatchMesh& mesh, const Rims& rims, double cell, double tolerance)
{
    PointGrid points(cell, rims.vertices.size());
    const auto position = [&mesh](std::uint32_t vertex) { return to_vec3(mesh.positions[vertex]); };
    for (const std::uint32_t vertex : rims.vertices)
        if (const auto earliest = points.first_near(position(vertex), tolerance, position))
            mesh.positions[vertex] = mesh.positions[*earliest];
        else
            points.insert(position(vertex), vertex);
    return points;
}

/// The points that lie on an edge between its ends, sorted from its first corner to its second.
std::vector<EdgeCut> cuts_of(const PatchMesh& mesh, RimEdge edge, const PointGrid& points, double cell,
                             double tolerance)
{
    const auto [first, second] = ends_of(mesh, edge);
    const Vec3 start = to_vec3(mesh.positions[first]);
    const Vec3 along = to_vec3(mesh.positions[second]) - start;
    const double extent = length(along);
    const Vec3 margin = {tolerance, tolerance, tolerance};
    const double steps = std::max(1.0, std::ceil(extent / cell)); // small boxes, as a large one overlaps too many cells
    std::vector<EdgeCut> cuts;
    for (double step = 0.0; step < steps; step += 1.0) {
        Bounds box;
        box.include(start + step / steps * along);
        box.include(start + (step + 1.0) / steps * along);
        points.visit_box(box.low - margin, box.high + margin, [&](std::uint32_t vertex) {
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

/// Removes the cracks between sides. Corners of different sides within `tolerance` [scene units] get the same position,
/// and a face with a corner of another side on its edge is split into triangles that meet there. Colours do not change,
/// since the values of new vertices are interpolated.
PatchMesh stitched(PatchMesh mesh, const Rims& rims, double tolerance)
{
    if (rims.edges.empty())
        return mesh;
    const double cell = std::max(2.0 * mean_length(mesh, rims), tolerance);
    const PointGrid points = join_corners(mesh, rims, cell, tolerance);
    std::vector<EdgeCut> cuts;
    for (const RimEdge edge : rims.edges) {
        const std::vector<EdgeCut> more = cuts_of(mesh, edge, points, cell, tolerance);
        cuts.insert(cuts.end(), more.begin(), more.end());
    }
    return cuts.empty() ? mesh : CutMesh(mesh, cuts).result();
}

/// Builds a mesh side by side.
class MeshBuilder
{
public:
    MeshBuilder(const Scene& scene, const CornerFunction& radiosity, const CornerFunction& error, int threads)
        : scene_(scene), radiosity_(radiosity), error_(error), covered_(covered_patches(scene, threads))
    {
        mesh_.origin = mesh_origin(scene);
        mesh_.faces.reserve(scene.patch_count());
    }

    void add_side(std::uint32_t surface, bool front)
    {
        const Tessellation& tessellation = scene_.tessellation(surface);
        const std::uint32_t first_patch = scene_.first_patch(surface, front);
        const auto cells = static_cast<std::uint32_t>(tessellation.cell_count());
        const std::size_t first_vertex = mesh_.positions.size();
        const std::size_t first_face = mesh_.faces.size();
        latest_.clear();
        latest_.reserve(cells + cells / 8 + std::size_t{1});
        const auto first = covered_.begin() + first_patch;
        has_inner_rims_ = tessellation.trees || std::find(first, first + cells, true) != first + cells;
        for (std::uint32_t patch = first_patch; patch < first_patch + cells; ++patch)
            if (!covered_[patch])
                add_face(patch, surface, front);
        const Vec3 normal = scene_.surfaces()[surface].normal();
        mesh_.sides.push_back({surface, front, front ? normal : -normal, first_vertex,
                               mesh_.positions.size() - first_vertex, first_face, mesh_.faces.size() - first_face});
    }

    /// The mesh of all sides that were added, without cracks between them.
    PatchMesh joined(double tolerance) && { return stitched(std::move(mesh_), rims_, tolerance); }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    void add_face(std::uint32_t patch, std::uint32_t surface, bool front)
    {
        const Tessellation& cut = scene_.tessellation(surface);
        const CellCorners corners = scene_.corners(patch);
        const std::array<Rgb, 4> radiosity = radiosity_(patch);
        const std::array<Rgb, 4> error = error_ ? error_(patch) : std::array<Rgb, 4>{};
        MeshFace face;
        face.corner_count = static_cast<std::uint32_t>(corners.count);
        face.patch = patch;
        const auto turn = [&](std::size_t k) { return front ? k : corners.count - 1 - k; };
        for (std::size_t k = 0; k < corners.count; ++k) {
            const std::size_t here = turn(k);
            face.corners[k] = vertex(surface, corners.points[here], single(radiosity[here]), single(error[here]));
            if (has_inner_rims_ ||
                (rim_of(cut, corners.points[here]) & rim_of(cut, corners.points[turn((k + 1) % corners.count)])) != 0)
                rims_.edges.push_back({static_cast<std::uint32_t>(mesh_.faces.size()), static_cast<std::uint32_t>(k)});
        }
        mesh_.faces.push_back(face);
    }

    /// The latest vertex at this point of the grid if it has these values, otherwise a new one.
    std::uint32_t vertex(std::uint32_t surface, GridPoint point, Float3 radiosity, Float3 error)
    {
        const Tessellation& tessellation = scene_.tessellation(surface);
        std::uint32_t& latest = latest_.try_emplace(std::uint64_t{point.j} << 32 | point.i, none).first->second;
        if (latest != none && mesh_.radiosity[latest] == radiosity && (!error_ || mesh_.error[latest] == error))
            return latest;
        if (mesh_.positions.size() == std::numeric_limits<std::int32_t>::max())
            throw InputError(scene_.path() + ": too many patches for a mesh, which has less than 2^31 vertices",
                             {{Remedy::patch_size, "", "makes them larger"}});
        latest = static_cast<std::uint32_t>(mesh_.positions.size());
        mesh_.positions.push_back(
            single(scene_.surfaces()[surface].at(static_cast<double>(point.i) / tessellation.grid_u(),
                                                 static_cast<double>(point.j) / tessellation.grid_v()) -
                   mesh_.origin));
        mesh_.radiosity.push_back(radiosity);
        if (error_)
            mesh_.error.push_back(error);
        if (has_inner_rims_ || rim_of(tessellation, point) != 0)
            rims_.vertices.push_back(latest);
        return latest;
    }

    const Scene& scene_;
    const CornerFunction& radiosity_;
    const CornerFunction& error_;
    std::vector<bool> covered_; ///< per patch
    /// True if the side has covered patches or patches of different sizes. Then every edge may be on the rim of a hole,
    /// or have corners of smaller patches on it.
    bool has_inner_rims_ = false;
    std::unordered_map<std::uint64_t, std::uint32_t> latest_; ///< latest vertex per point of the side's grid
    PatchMesh mesh_;
    Rims rims_;
};

} // namespace

CornerFunction flat_corners(const std::vector<Rgb>& values_per_patch)
{
    return [&values_per_patch](std::uint32_t patch) {
        const Rgb value = values_per_patch[patch];
        return std::array<Rgb, 4>{value, value, value, value};
    };
}

PatchMesh patch_mesh(const Scene& scene, const CornerFunction& radiosity, const CornerFunction& error, int threads)
{
    MeshBuilder builder(scene, radiosity, error, threads);
    for (std::uint32_t surface = 0; surface < scene.own_surfaces(); ++surface) {
        builder.add_side(surface, true);
        if (scene.two_sided())
            builder.add_side(surface, false);
    }
    return std::move(builder).joined(coinciding * scene.bounds().diagonal());
}

} // namespace multipath
