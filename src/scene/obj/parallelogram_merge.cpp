// Every two triangles with a common edge may form a parallelogram, and in a regular mesh a triangle has up to three
// such partners. The diagonal of a rectangle is the longest edge of both its halves, so pairs across a longest
// edge are joined first. That restores the rectangles that an exporter cut, in whatever order it wrote their halves. A
// second pass joins pairs across the other edges.

#include "scene/obj/parallelogram_merge.h"

#include "scene/vertex_weld.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace multipath {

namespace {

using Corners = std::array<std::uint32_t, 4>;

class TriangleMerger
{
public:
    TriangleMerger(LargeVector<Piece>& pieces, const ObjMesh& mesh, const SceneScale& scale)
        : pieces_(pieces), mesh_(mesh), scale_(scale)
    {
    }
    std::size_t merge();

private:
    void weld_corners();
    void list_triangles_by_vertex();
    void merge_across_edges(bool longest);
    void merge_across_edge(std::uint32_t first, std::size_t edge);
    bool merge_pair(std::uint32_t first, std::size_t edge, std::uint32_t second);
    std::size_t longest_edge_of(const Corners& triangle) const;
    /// True for a triangle that is not joined yet.
    bool is_free(std::uint32_t piece) const { return pieces_[piece].is_triangle() && !is_removed(pieces_[piece]); }
    static bool is_removed(const Piece& piece) { return piece.corners[0] == Piece::no_vertex; }
    Vec3 at(std::uint32_t vertex) const { return mesh_.vertices[vertex]; }
    bool are_same_point(std::uint32_t a, std::uint32_t b) const
    {
        if (a == b || a == ObjMesh::no_point || b == ObjMesh::no_point)
            return a == b;
        const TexturePoint p = mesh_.texture_points[a];
        const TexturePoint q = mesh_.texture_points[b];
        return p.s == q.s && p.t == q.t;
    }

    LargeVector<Piece>& pieces_;
    const ObjMesh& mesh_;
    const SceneScale scale_;
    /// The triangles at vertex v are triangles_[starts_[v]] ... triangles_[starts_[v + 1] - 1].
    LargeVector<std::uint32_t> starts_, triangles_;
    std::size_t pair_count_ = 0;
};

std::size_t TriangleMerger::merge()
{
    weld_corners();
    list_triangles_by_vertex();
    merge_across_edges(true);
    merge_across_edges(false);
    pieces_.erase(std::remove_if(pieces_.begin(), pieces_.end(), is_removed), pieces_.end());
    return pair_count_;
}

/// Gives corners at the same position the same vertex.
void TriangleMerger::weld_corners()
{
    const LargeVector<std::uint32_t> welded = weld(mesh_.vertices);
    for (Piece& piece : pieces_)
        for (std::uint32_t& corner : piece.corners)
            corner = corner == Piece::no_vertex ? corner : welded[corner];
}

/// Fills starts_ and triangles_ by a counting sort, which keeps the order of the triangles at a vertex.
void TriangleMerger::list_triangles_by_vertex()
{
    starts_.assign(mesh_.vertices.size() + 1, 0);
    for (std::uint32_t i = 0; i < pieces_.size(); ++i)
        for (std::size_t k = 0; k < 3 && is_free(i); ++k)
            ++starts_[pieces_[i].corners[k]];
    std::uint32_t sum = 0;
    for (std::uint32_t& start : starts_)
        start = sum += start; // the end for now; filling from the back turns it into the start
    triangles_.resize(sum);
    for (std::uint32_t i = static_cast<std::uint32_t>(pieces_.size()); i-- > 0;)
        for (std::size_t k = 0; k < 3 && is_free(i); ++k)
            triangles_[--starts_[pieces_[i].corners[k]]] = i;
}

/// Joins triangles across the longest edge of each triangle, or across its two other edges.
void TriangleMerger::merge_across_edges(bool longest)
{
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
        if (!is_free(i))
            continue;
        const std::size_t longest_edge = longest_edge_of(pieces_[i].corners);
        for (std::size_t edge = 0; edge < 3 && is_free(i); ++edge)
            if ((edge == longest_edge) == longest)
                merge_across_edge(i, edge);
    }
}

/// Joins a triangle with a later one that has the edge in the opposite direction, if they form a parallelogram.
void TriangleMerger::merge_across_edge(std::uint32_t first, std::size_t edge)
{
    constexpr std::ptrdiff_t most_candidates = 64; // limits the time if all triangles of a file share a vertex
    const std::uint32_t vertex = pieces_[first].corners[edge];
    const auto end = triangles_.begin() + starts_[vertex + 1];
    const auto begin = std::upper_bound(triangles_.begin() + starts_[vertex], end, first);
    for (auto other = begin; other != end && other - begin < most_candidates; ++other)
        if (is_free(*other) && merge_pair(first, edge, *other))
            return;
}

/// Joins two triangles if they form a parallelogram across this edge of the first: it replaces the first triangle, and
/// the second is marked as removed. Returns true if they were joined.
bool TriangleMerger::merge_pair(std::uint32_t first, std::size_t edge, std::uint32_t second)
{
    const Corners p = pieces_[first].corners;
    const Corners q = pieces_[second].corners;
    const std::uint32_t from = p[edge];
    const std::uint32_t to = p[(edge + 1) % 3];
    std::size_t opposite = 0; // corner of the second that is not on the edge
    while (opposite < 3 && (q[(opposite + 1) % 3] != to || q[(opposite + 2) % 3] != from))
        ++opposite;
    const ObjFace& face = mesh_.faces[pieces_[first].face];
    const ObjFace& other_face = mesh_.faces[pieces_[second].face];
    if (opposite == 3 || face.material != other_face.material || face.group != other_face.group ||
        pieces_[first].colour != pieces_[second].colour)
        return false;

    const auto join = [&](const Corners& a, const Corners& b) {
        Corners joined = {a[0], a[1], a[2], a[2]};
        if (edge == 0)
            joined[2] = a[1];
        joined[edge + 1] = b[opposite];
        return joined;
    };
    const Corners joined = join(p, q);
    if (!is_parallelogram(at(joined[0]), at(joined[1]), at(joined[2]), at(joined[3]), scale_))
        return false;
    const Corners& s = pieces_[first].points;
    const Corners& t = pieces_[second].points;
    const Corners points = join(s, t);
    if (mesh_.is_textured(face) &&
        !(are_same_point(s[edge], t[(opposite + 2) % 3]) && are_same_point(s[(edge + 1) % 3], t[(opposite + 1) % 3]) &&
          is_parallelogram(points, mesh_)))
        return false;
    pieces_[first].corners = joined;
    pieces_[first].points = points;
    pieces_[second].corners[0] = Piece::no_vertex;
    ++pair_count_;
    return true;
}

/// The index i of the longest edge, which runs from corner i to the next.
std::size_t TriangleMerger::longest_edge_of(const Corners& triangle) const
{
    std::array<double, 3> squares = {};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 edge = at(triangle[(i + 1) % 3]) - at(triangle[i]);
        squares[i] = dot(edge, edge);
    }
    return static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
}

} // namespace

std::size_t merge_triangles(LargeVector<Piece>& pieces, const ObjMesh& mesh, const SceneScale& scale)
{
    return TriangleMerger(pieces, mesh, scale).merge();
}

} // namespace multipath
