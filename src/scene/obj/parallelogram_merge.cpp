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

using Corners = std::array<ObjCorner, 4>;

class TriangleMerger
{
public:
    TriangleMerger(LargeVector<Piece>& pieces, const ObjMesh& mesh, const SceneScale& scale)
        : pieces_(pieces), mesh_(mesh), scale_(scale)
    {
    }

    void merge()
    {
        weld_corners();
        list_triangles_by_vertex();
        merge_across_edges(true);
        merge_across_edges(false);
        pieces_.erase(std::remove_if(pieces_.begin(), pieces_.end(), is_removed), pieces_.end());
    }

private:
    /// True for a triangle that is not joined yet.
    bool is_free(std::uint32_t piece) const { return pieces_[piece].is_triangle() && !is_removed(pieces_[piece]); }
    static bool is_removed(const Piece& piece) { return piece.corners[0].vertex == ObjCorner::none; }

    /// Gives corners at the same position the same vertex.
    void weld_corners()
    {
        const LargeVector<std::uint32_t> welded = weld(mesh_.vertices);
        for (Piece& piece : pieces_)
            for (std::size_t k = 0; k < piece.corner_count(); ++k)
                piece.corners[k].vertex = welded[piece.corners[k].vertex];
    }

    /// Fills starts_ and triangles_ by a counting sort, which keeps the order of the triangles at a vertex.
    void list_triangles_by_vertex()
    {
        starts_.assign(mesh_.vertices.size() + 1, 0);
        for (std::uint32_t i = 0; i < pieces_.size(); ++i)
            for (std::size_t k = 0; k < 3 && is_free(i); ++k)
                ++starts_[pieces_[i].corners[k].vertex];
        std::uint32_t sum = 0;
        for (std::uint32_t& start : starts_)
            start = sum += start; // the end for now; filling from the back turns it into the start
        triangles_.resize(sum);
        for (std::uint32_t i = static_cast<std::uint32_t>(pieces_.size()); i-- > 0;)
            for (std::size_t k = 0; k < 3 && is_free(i); ++k)
                triangles_[--starts_[pieces_[i].corners[k].vertex]] = i;
    }

    /// Joins triangles across the longest edge of each triangle, or across its two other edges.
    void merge_across_edges(bool longest)
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
    void merge_across_edge(std::uint32_t first, std::size_t edge)
    {
        constexpr std::ptrdiff_t most_candidates = 64; // limits the time if all triangles of a file share a vertex
        const std::uint32_t vertex = pieces_[first].corners[edge].vertex;
        const auto end = triangles_.begin() + starts_[vertex + 1];
        const auto begin = std::upper_bound(triangles_.begin() + starts_[vertex], end, first);
        for (auto other = begin; other != end && other - begin < most_candidates; ++other)
            if (is_free(*other) && merge_pair(pieces_[first], edge, pieces_[*other]))
                return;
    }

    /// Joins two triangles if they form a parallelogram across this edge of the first: it replaces the first triangle,
    /// and the second is marked as removed. Returns true if they were joined.
    bool merge_pair(Piece& first, std::size_t edge, Piece& second)
    {
        const Corners& p = first.corners;
        const Corners& q = second.corners;
        const ObjCorner from = p[edge];
        const ObjCorner to = p[(edge + 1) % 3];
        std::size_t opposite = 0; // corner of the second that is not on the edge
        while (opposite < 3 &&
               (q[(opposite + 1) % 3].vertex != to.vertex || q[(opposite + 2) % 3].vertex != from.vertex))
            ++opposite;
        const ObjFace& face = mesh_.faces[first.face];
        const ObjFace& other_face = mesh_.faces[second.face];
        if (opposite == 3 || face.material != other_face.material || face.group != other_face.group ||
            first.colour != second.colour)
            return false;

        Corners joined = {p[0], p[1], p[2], p[2]};
        if (edge == 0)
            joined[2] = p[1];
        joined[edge + 1] = q[opposite];
        if (!is_parallelogram(mesh_.at(joined[0]), mesh_.at(joined[1]), mesh_.at(joined[2]), mesh_.at(joined[3]),
                              scale_))
            return false;
        if (mesh_.is_textured(face) &&
            !(are_same_point(to, q[(opposite + 1) % 3]) && are_same_point(from, q[(opposite + 2) % 3]) &&
              is_texture_parallelogram(joined, mesh_)))
            return false;
        first.corners = joined;
        second.corners[0].vertex = ObjCorner::none;
        return true;
    }

    bool are_same_point(ObjCorner a, ObjCorner b) const
    {
        if (a.point == b.point || a.point == ObjCorner::none || b.point == ObjCorner::none)
            return a.point == b.point;
        const TexturePoint p = mesh_.texture_points[a.point];
        const TexturePoint q = mesh_.texture_points[b.point];
        return p.s == q.s && p.t == q.t;
    }

    /// The index i of the longest edge, which runs from corner i to the next.
    std::size_t longest_edge_of(const Corners& triangle) const
    {
        std::array<double, 3> squares = {};
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 edge = mesh_.at(triangle[(i + 1) % 3]) - mesh_.at(triangle[i]);
            squares[i] = dot(edge, edge);
        }
        return static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
    }

    LargeVector<Piece>& pieces_;
    const ObjMesh& mesh_;
    const SceneScale scale_;
    /// The triangles at vertex v are triangles_[starts_[v]] ... triangles_[starts_[v + 1] - 1].
    LargeVector<std::uint32_t> starts_, triangles_;
};

} // namespace

void merge_triangles(LargeVector<Piece>& pieces, const ObjMesh& mesh, const SceneScale& scale)
{
    TriangleMerger(pieces, mesh, scale).merge();
}

} // namespace multipath
