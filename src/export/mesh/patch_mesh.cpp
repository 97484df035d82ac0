// Surfaces are cut one by one. Two that share a whole edge are cut alike there, but one wall beside two, or a triangle
// beside a rectangle, are not: a corner of one then lies on an edge of the other, and drawn in single precision, they
// leave gaps of a fraction of a pixel. So every edge on the rim of a side gets the corners that others have on it.

#include "export/mesh/patch_mesh.h"

#include "export/mesh/covered_patches.h"
#include "geometry/bounds.h"
#include "geometry/vec3.h"
#include "sampling/random.h"
#include "scene/input_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>

namespace multipath {

namespace {

constexpr double coinciding = 1e-6; ///< of the scene's diagonal: closer corners are one

bool on_rim(const Tessellation& cut, GridPoint a)
{
    const bool slanted = cut.shape == Shape::triangle && a.i + a.j == cut.grid_u();
    return slanted || a.i == 0 || a.i == cut.grid_u() || a.j == 0 || a.j == cut.grid_v();
}

/// True if the edge between two neighbours on the grid is part of the surface's rim.
bool on_rim(const Tessellation& cut, GridPoint a, GridPoint b)
{
    const bool slanted = cut.shape == Shape::triangle && a.i + a.j == cut.grid_u() && b.i + b.j == cut.grid_u();
    return slanted || (a.i == b.i && (a.i == 0 || a.i == cut.grid_u())) ||
           (a.j == b.j && (a.j == 0 || a.j == cut.grid_v()));
}

/// The edge of a face from one of its corners to the next, on the rim of its side.
struct RimEdge
{
    std::uint32_t face = 0;
    std::uint32_t corner = 0; ///< 0 to 3
};

/// The rims of all sides, along which they are joined.
struct Rims
{
    std::vector<RimEdge> edges;          ///< in the order of the faces
    std::vector<std::uint32_t> vertices; ///< in the order of the vertices
};

/// Numbered points in a hash table of the cells of a regular grid.
class PointGrid
{
public:
    /// The edge of a cell and how many points to expect.
    PointGrid(double cell, std::size_t expected) : cell_(cell) { points_.reserve(expected); }

    void insert(Vec3 point, std::uint32_t number)
    {
        points_[key(index(point.x), index(point.y), index(point.z))].push_back(number);
    }

    /// Calls visit(number) for all points in a box, and for others in the same cells.
    template <class Visit>
    void visit_box(Vec3 low, Vec3 high, const Visit& visit) const
    {
        for (std::int64_t x = index(low.x); x <= index(high.x); ++x)
            for (std::int64_t y = index(low.y); y <= index(high.y); ++y)
                for (std::int64_t z = index(low.z); z <= index(high.z); ++z)
                    if (const auto found = points_.find(key(x, y, z)); found != points_.end())
                        for (const std::uint32_t number : found->second)
                            visit(number);
    }

private:
    std::int64_t index(double x) const { return static_cast<std::int64_t>(std::floor(x / cell_)); }
    static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z)
    {
        std::uint64_t bits = 0;
        for (const std::int64_t n : {x, y, z})
            bits = mix_bits(bits ^ static_cast<std::uint64_t>(n));
        return bits;
    }

    double cell_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> points_;
};

/// A place on the rim of a side where a corner of another side lies.
struct EdgeCut
{
    RimEdge edge;
    double share = 0.0;       ///< of the way along the edge, in (0, 1)
    std::uint32_t vertex = 0; ///< of the other side
};

/// A vertex's part in a mixture.
struct Share
{
    std::uint32_t vertex = 0;
    double weight = 0.0;
};

Float3 mixed(const std::vector<Float3>& values, const std::vector<Share>& mixture)
{
    Rgb sum;
    for (const Share& share : mixture)
        sum += share.weight * to_rgb(values[share.vertex]);
    return single(sum);
}

/// Copies a mesh side by side.
class CutMesh
{
public:
    CutMesh(const PatchMesh& whole, const std::vector<EdgeCut>& cuts) : whole_(whole), cuts_(cuts) {}

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
                add_fan(whole_.faces[face], rim_of(whole_.faces[face], face));
            else
                add_face(whole_.faces[face]);
        side.vertex_count = result_.positions.size() - side.first_vertex;
        side.face_count = result_.faces.size() - side.first_face;
        result_.sides.push_back(side);
    }

    PatchMesh result() && { return std::move(result_); }

private:
    void add_face(MeshFace face)
    {
        for (std::uint32_t& corner : face.corners)
            corner += shift_;
        result_.faces.push_back(face);
    }

    std::uint32_t add_vertex(Float3 position, const std::vector<Share>& mixture)
    {
        result_.positions.push_back(position);
        result_.radiosity.push_back(mixed(whole_.radiosity, mixture));
        if (!whole_.error.empty())
            result_.error.push_back(mixed(whole_.error, mixture));
        return static_cast<std::uint32_t>(result_.positions.size() - 1);
    }

    /// All around a face, its own corners and the cuts; these it takes.
    std::vector<std::uint32_t> rim_of(const MeshFace& face, std::size_t number)
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

    /// Around the middle no triangle is degenerate, wherever the cuts are.
    void add_fan(const MeshFace& face, const std::vector<std::uint32_t>& rim)
    {
        std::vector<Share> corners;
        for (const std::uint32_t corner : face)
            corners.push_back({corner, 1.0 / face.corner_count});
        const std::uint32_t middle = add_vertex(mixed(whole_.positions, corners), corners);
        for (std::size_t n = 0; n < rim.size(); ++n)
            result_.faces.push_back({{middle, rim[n], rim[(n + 1) % rim.size()], 0}, 3, face.patch});
    }

    const PatchMesh& whole_;
    const std::vector<EdgeCut>& cuts_;
    std::size_t next_ = 0;    ///< the first cut that is not yet made
    std::uint32_t shift_ = 0; ///< from old numbers of the side's vertices to new ones
    PatchMesh result_;
};

/// The mesh with every face that has cuts replaced by triangles around its middle, which meet the other side's corners.
/// Cuts are in the order of faces, of a face's corners, and along each edge. New vertices have the values [W/m^2] of
/// where they are.
PatchMesh with_cuts(const PatchMesh& mesh, const std::vector<EdgeCut>& cuts)
{
    CutMesh result(mesh, cuts);
    for (const MeshSide& side : mesh.sides)
        result.add_side(side);
    return std::move(result).result();
}

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

/// Moves the corners on rims to the first one within the tolerance, and returns all such places.
PointGrid join_corners(PatchMesh& mesh, const Rims& rims, double cell, double tolerance)
{
    PointGrid places(cell, rims.vertices.size());
    const Vec3 margin = {tolerance, tolerance, tolerance};
    for (const std::uint32_t vertex : rims.vertices) {
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

/// The mesh without cracks: where corners of sides lie within `tolerance` [scene units] they come to lie in one place,
/// and a face on whose edge another side has a corner is cut into triangles that meet there. Colours stay as they were:
/// new corners get the values of where they are.
PatchMesh sewn(PatchMesh mesh, const Rims& rims, double tolerance)
{
    if (rims.edges.empty())
        return mesh;
    const double cell = std::max(2.0 * mean_length(mesh, rims), tolerance);
    const PointGrid places = join_corners(mesh, rims, cell, tolerance);
    std::vector<EdgeCut> cuts;
    for (const RimEdge edge : rims.edges) {
        const std::vector<EdgeCut> more = cuts_of(mesh, edge, places, cell, tolerance);
        cuts.insert(cuts.end(), more.begin(), more.end());
    }
    return cuts.empty() ? mesh : with_cuts(mesh, cuts);
}

/// Adds sides to a mesh, patch by patch.
class MeshBuilder
{
public:
    MeshBuilder(const Scene& scene, const CornerFunction& radiosity, const CornerFunction& error, int threads)
        : scene_(scene), radiosity_(radiosity), error_(error), covered_(covered_patches(scene, threads))
    {
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
        mesh_.sides.push_back({surface, front ? normal : -normal, first_vertex, mesh_.positions.size() - first_vertex,
                               first_face, mesh_.faces.size() - first_face});
    }

    /// Of all sides that were added.
    PatchMesh joined(double tolerance) && { return sewn(std::move(mesh_), rims_, tolerance); }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    void add_face(std::uint32_t patch, std::uint32_t surface, bool front)
    {
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
            if (has_inner_rims_ || on_rim(scene_.tessellation(surface), corners.points[here],
                                          corners.points[turn((k + 1) % corners.count)]))
                rims_.edges.push_back({static_cast<std::uint32_t>(mesh_.faces.size()), static_cast<std::uint32_t>(k)});
        }
        mesh_.faces.push_back(face);
    }

    /// The latest vertex at this point if it has these values, else a new one.
    std::uint32_t vertex(std::uint32_t surface, GridPoint point, Float3 radiosity, Float3 error)
    {
        const Tessellation& tessellation = scene_.tessellation(surface);
        std::uint32_t& latest = latest_.try_emplace(std::uint64_t{point.j} << 32 | point.i, none).first->second;
        if (latest != none && mesh_.radiosity[latest] == radiosity && (!error_ || mesh_.error[latest] == error))
            return latest;
        if (mesh_.positions.size() == std::numeric_limits<std::int32_t>::max())
            throw InputError(scene_.path() + ": too many patches for a mesh, which has less than 2^31 vertices; choose "
                                             "larger ones with --patch-size");
        latest = static_cast<std::uint32_t>(mesh_.positions.size());
        mesh_.positions.push_back(
            single(scene_.surfaces()[surface].at(static_cast<double>(point.i) / tessellation.grid_u(),
                                                 static_cast<double>(point.j) / tessellation.grid_v())));
        mesh_.radiosity.push_back(radiosity);
        if (error_)
            mesh_.error.push_back(error);
        if (has_inner_rims_ || on_rim(tessellation, point))
            rims_.vertices.push_back(latest);
        return latest;
    }

    const Scene& scene_;
    const CornerFunction& radiosity_;
    const CornerFunction& error_;
    std::vector<bool> covered_; ///< per patch
    /// The side has covered patches, or patches of different sizes: every edge may be on the rim of a hole, or have
    /// corners of smaller patches on it.
    bool has_inner_rims_ = false;
    std::unordered_map<std::uint64_t, std::uint32_t> latest_; ///< by point of the side's grid
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
