#include "export/edge_cuts.h"

#include <utility>

namespace multipath {

namespace {

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

} // namespace

PatchMesh with_cuts(const PatchMesh& mesh, const std::vector<EdgeCut>& cuts)
{
    CutMesh result(mesh, cuts);
    for (const MeshSide& side : mesh.sides)
        result.add_side(side);
    return std::move(result).result();
}

} // namespace multipath
