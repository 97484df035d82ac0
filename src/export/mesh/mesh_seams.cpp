// Surfaces are cut one by one. Two that share a whole edge are cut alike there, but one wall beside two, or a triangle
// beside a rectangle, are not: a corner of one then lies on an edge of the other, and drawn in single precision, they
// leave gaps of a fraction of a pixel. So every edge on the rim of a side gets the corners that others have on it.

#include "export/mesh/mesh_seams.h"

#include "geometry/bounds.h"
#include "geometry/vec3.h"
#include "sampling/random.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace multipath {

namespace {

/// Numbered points in a hash table of the cells of a regular grid.
class PointGrid
{
public:
    /// The edge of a cell and how many points to expect; more make it slower.
    PointGrid(double cell, std::size_t expected) : cell_(cell)
    {
        std::size_t buckets = 16;
        while (buckets < expected)
            buckets *= 2;
        heads_.assign(buckets, none);
        entries_.reserve(expected);
    }

    void insert(Vec3 point, std::uint32_t number)
    {
        std::uint32_t& head = heads_[bucket(index(point.x), index(point.y), index(point.z))];
        entries_.push_back({number, head});
        head = static_cast<std::uint32_t>(entries_.size() - 1);
    }

    /// Calls visit(number) for all points in a box, and for others in the same buckets; for some perhaps twice.
    template <class Visit>
    void visit_box(Vec3 low, Vec3 high, const Visit& visit) const
    {
        for (std::int64_t x = index(low.x); x <= index(high.x); ++x)
            for (std::int64_t y = index(low.y); y <= index(high.y); ++y)
                for (std::int64_t z = index(low.z); z <= index(high.z); ++z)
                    for (std::uint32_t entry = heads_[bucket(x, y, z)]; entry != none; entry = entries_[entry].next)
                        visit(entries_[entry].number);
    }

private:
    struct Entry
    {
        std::uint32_t number;
        std::uint32_t next; ///< in the same bucket
    };
    static constexpr std::uint32_t none = 0xffffffffu;

    std::int64_t index(double x) const { return static_cast<std::int64_t>(std::floor(x / cell_)); }
    std::size_t bucket(std::int64_t x, std::int64_t y, std::int64_t z) const
    {
        std::uint64_t bits = 0;
        for (const std::int64_t n : {x, y, z})
            bits = mix_bits(bits ^ static_cast<std::uint64_t>(n));
        return static_cast<std::size_t>(bits) & (heads_.size() - 1);
    }

    double cell_;
    std::vector<std::uint32_t> heads_; ///< per bucket; a power of two of them
    std::vector<Entry> entries_;
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
