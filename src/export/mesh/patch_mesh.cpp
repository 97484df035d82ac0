#include "export/mesh/patch_mesh.h"

#include "export/mesh/covered_patches.h"
#include "export/mesh/mesh_seams.h"
#include "scene/input_error.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace multipath {

namespace {

constexpr double coinciding = 1e-6; ///< of the scene's diagonal: closer corners are one

bool on_rim(const Tessellation& cut, GridPoint a)
{
    const bool slanted = cut.shape == Shape::triangle && a.i + a.j == cut.cells_u;
    return slanted || a.i == 0 || a.i == cut.cells_u || a.j == 0 || a.j == cut.cells_v;
}

/// True if the edge between two neighbours on the grid is part of the surface's rim.
bool on_rim(const Tessellation& cut, GridPoint a, GridPoint b)
{
    const bool slanted = cut.shape == Shape::triangle && a.i + a.j == cut.cells_u && b.i + b.j == cut.cells_u;
    return slanted || (a.i == b.i && (a.i == 0 || a.i == cut.cells_u)) ||
           (a.j == b.j && (a.j == 0 || a.j == cut.cells_v));
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
        latest_.assign((std::size_t{tessellation.cells_u} + 1) * (std::size_t{tessellation.cells_v} + 1), none);
        const auto first = covered_.begin() + first_patch;
        has_holes_ = std::find(first, first + cells, true) != first + cells;
        for (std::uint32_t patch = first_patch; patch < first_patch + cells; ++patch)
            if (!covered_[patch])
                add_face(patch, surface, front);
        const Vec3 normal = scene_.surfaces()[surface].normal();
        mesh_.sides.push_back({surface, front ? normal : -normal, first_vertex, mesh_.positions.size() - first_vertex,
                               first_face, mesh_.faces.size() - first_face});
    }

    PatchMesh mesh() && { return std::move(mesh_); }

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
            if (has_holes_ || on_rim(scene_.tessellation(surface), corners.points[here],
                                     corners.points[turn((k + 1) % corners.count)]))
                mesh_.rims.push_back({static_cast<std::uint32_t>(mesh_.faces.size()), static_cast<std::uint32_t>(k)});
        }
        mesh_.faces.push_back(face);
    }

    /// The latest vertex at this point if it has these values, else a new one.
    std::uint32_t vertex(std::uint32_t surface, GridPoint point, Float3 radiosity, Float3 error)
    {
        const Tessellation& tessellation = scene_.tessellation(surface);
        std::uint32_t& latest = latest_[std::size_t{point.j} * (std::size_t{tessellation.cells_u} + 1) + point.i];
        if (latest != none && mesh_.radiosity[latest] == radiosity && (!error_ || mesh_.error[latest] == error))
            return latest;
        if (mesh_.positions.size() == std::numeric_limits<std::int32_t>::max())
            throw InputError(scene_.path() + ": too many patches for a mesh, which has less than 2^31 vertices; choose "
                                             "larger ones with --patch-size");
        latest = static_cast<std::uint32_t>(mesh_.positions.size());
        mesh_.positions.push_back(single(scene_.surfaces()[surface].at(
            static_cast<double>(point.i) / tessellation.cells_u, static_cast<double>(point.j) / tessellation.cells_v)));
        mesh_.radiosity.push_back(radiosity);
        if (error_)
            mesh_.error.push_back(error);
        if (has_holes_ || on_rim(tessellation, point))
            mesh_.rim_vertices.push_back(latest);
        return latest;
    }

    const Scene& scene_;
    const CornerFunction& radiosity_;
    const CornerFunction& error_;
    std::vector<bool> covered_;         ///< per patch
    bool has_holes_ = false;            ///< the side has covered patches: every edge may be on the rim of a hole
    std::vector<std::uint32_t> latest_; ///< per point of the side's grid
    PatchMesh mesh_;
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
    for (std::uint32_t surface = 0; surface < scene.surfaces().size(); ++surface) {
        builder.add_side(surface, true);
        if (scene.two_sided())
            builder.add_side(surface, false);
    }
    return sewn(std::move(builder).mesh(), coinciding * scene.bounds().diagonal());
}

} // namespace multipath
