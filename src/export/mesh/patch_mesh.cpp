#include "export/mesh/patch_mesh.h"

#include "base/errors.h"
#include "base/lists.h"
#include "export/mesh/point_grid.h"
#include "geometry/bounds.h"
#include "geometry/intersector/intersector.h"
#include "geometry/polygon.h"
#include "geometry/vec3.h"
#include "parallel/blocks.h"

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
            return lies_over(scene, surface, patch, front) && !is_among(surface, subtracted);
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

/// A place on an edge between its ends.
struct EdgePoint
{
    double share = 0.0; ///< [1] position along the edge, in (0, 1)
    Vec3 place;
};

/// Those of the points that lie on an edge between its ends, to within `tolerance` [scene units], in order along it.
std::vector<EdgePoint> points_on_edge(const PointGrid& points, Vec3 start, Vec3 end, double tolerance)
{
    const Vec3 along = end - start;
    const double extent = length(along);
    const Vec3 margin = {tolerance, tolerance, tolerance};
    const double steps = std::max(1.0, std::ceil(extent / points.cell())); // a large box overlaps too many cells
    std::vector<EdgePoint> found;
    for (double step = 0.0; step < steps; step += 1.0) {
        Bounds box;
        box.include(start + step / steps * along);
        box.include(start + (step + 1.0) / steps * along);
        points.visit_box(box.low - margin, box.high + margin, [&](Vec3 point) {
            const Vec3 way = point - start;
            const double share = dot(way, along) / (extent * extent);
            const bool inside = share * extent > tolerance && (1.0 - share) * extent > tolerance;
            if (inside && length(way - share * along) <= tolerance)
                found.push_back({share, point});
        });
    }
    std::sort(found.begin(), found.end(), [](const EdgePoint& a, const EdgePoint& b) { return a.share < b.share; });
    const auto same = [](const EdgePoint& a, const EdgePoint& b) { return a.share == b.share; };
    found.erase(std::unique(found.begin(), found.end(), same), found.end());
    return found;
}

/// Builds a mesh in two passes over all sides: the first finds the corners on their rims, the second makes the faces.
class MeshBuilder
{
public:
    MeshBuilder(const Scene& scene, const CornerFunction& radiosity, const CornerFunction& error, int threads)
        : scene_(scene),
          radiosity_(radiosity),
          error_(error),
          covered_(covered_patches(scene, threads)),
          tolerance_(coinciding * scene.bounds().diagonal()),
          points_(std::max(half_an_edge * std::sqrt(scene.total_area() / scene.patch_count()), tolerance_))
    {
        mesh_.origin = mesh_origin(scene);
        mesh_.faces.reserve(scene.patch_count());
        for_each_side([this] { find_rim(); });
        for_each_side([this] { add_side(); });
    }

    PatchMesh result() && { return std::move(mesh_); }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    static constexpr double half_an_edge = 0.5; ///< of a mean patch, since most corners belong to smaller ones

    /// Calls act() for the front of each surface and for the back if there is one, as the current side.
    template <class Act>
    void for_each_side(const Act& act)
    {
        for (std::uint32_t surface = 0; surface < scene_.own_surfaces(); ++surface)
            for (const bool front : {true, false})
                if (front || scene_.two_sided()) {
                    begin_side(surface, front);
                    act();
                }
    }

    void begin_side(std::uint32_t surface, bool front)
    {
        surface_ = surface;
        front_ = front;
        patches_.clear();
        const std::uint32_t first = scene_.first_patch(surface, front);
        const std::size_t cells = scene_.tessellation(surface).cell_count();
        for (std::uint32_t patch = first; patch < first + cells; ++patch)
            if (!covered_[patch])
                patches_.push_back(patch);
        has_inner_rims_ = scene_.tessellation(surface).trees || patches_.size() < cells;
    }

    /// True if the corners of other patches may lie beside this point of the grid.
    bool is_on_rim(GridPoint a) const
    {
        const Tessellation& cut = scene_.tessellation(surface_);
        const bool outer =
            cut.shape == Shape::triangle ? a.i + a.j == cut.grid_u() : a.i == cut.grid_u() || a.j == cut.grid_v();
        return has_inner_rims_ || a.i == 0 || a.j == 0 || outer;
    }

    /// [scene units] Relative to the origin of the mesh, in single precision.
    Vec3 place_of(GridPoint a) const
    {
        const Tessellation& cut = scene_.tessellation(surface_);
        const Vec3 place = scene_.surfaces()[surface_].at(static_cast<double>(a.i) / cut.grid_u(),
                                                          static_cast<double>(a.j) / cut.grid_v());
        return to_vec3(single(place - mesh_.origin));
    }

    void find_rim()
    {
        for (const std::uint32_t patch : patches_) {
            const CellCorners corners = scene_.corners(patch);
            for (std::size_t k = 0; k < corners.count; ++k)
                if (is_on_rim(corners.points[k]))
                    points_.joined(place_of(corners.points[k]), tolerance_);
        }
    }

    void add_side()
    {
        const std::size_t first_vertex = mesh_.positions.size();
        const std::size_t first_face = mesh_.faces.size();
        latest_.clear();
        latest_.reserve(patches_.size() + patches_.size() / 8 + std::size_t{1});
        for (const std::uint32_t patch : patches_)
            add_face(patch);
        const Vec3 normal = scene_.surfaces()[surface_].normal();
        mesh_.sides.push_back({surface_, front_, front_ ? normal : -normal, first_vertex,
                               mesh_.positions.size() - first_vertex, first_face, mesh_.faces.size() - first_face});
    }

    /// Adds a patch as a face; if other corners lie on its edges, as a fan of triangles around its centroid: none of
    /// them is degenerate, wherever these corners are. Values are interpolated, so that colours do not change.
    void add_face(std::uint32_t patch)
    {
        const CellCorners corners = scene_.corners(patch);
        const std::array<Rgb, 4> radiosity = radiosity_(patch);
        const std::array<Rgb, 4> error = error_ ? error_(patch) : std::array<Rgb, 4>{};
        MeshFace face;
        face.corner_count = static_cast<std::uint32_t>(corners.count);
        face.patch = patch;
        const auto turned = [&](std::size_t k) {
            return front_ ? k % corners.count : corners.count - 1 - k % corners.count;
        };
        for (std::size_t k = 0; k < corners.count; ++k)
            face.corners[k] = vertex(corners.points[turned(k)], single(radiosity[turned(k)]), single(error[turned(k)]));

        around_.clear();
        for (std::size_t k = 0; k < corners.count; ++k) {
            around_.push_back(face.corners[k]);
            const std::size_t a = turned(k);
            const std::size_t b = turned(k + 1);
            if (!is_on_rim(corners.points[a]) || !is_on_rim(corners.points[b]))
                continue;
            const auto between = [&](const std::array<Rgb, 4>& values, double share) {
                return single((1.0 - share) * values[a] + share * values[b]);
            };
            for (const EdgePoint& point :
                 points_on_edge(points_, to_vec3(mesh_.positions[face.corners[k]]),
                                to_vec3(mesh_.positions[face.corners[(k + 1) % corners.count]]), tolerance_))
                around_.push_back(
                    add_vertex(point.place, between(radiosity, point.share), between(error, point.share)));
        }
        if (around_.size() == corners.count)
            mesh_.faces.push_back(face);
        else
            add_fan(face, radiosity, error);
    }

    void add_fan(const MeshFace& face, const std::array<Rgb, 4>& radiosity, const std::array<Rgb, 4>& error)
    {
        const double weight = 1.0 / face.corner_count;
        Vec3 centroid;
        Rgb mean_radiosity;
        Rgb mean_error;
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            centroid = centroid + weight * to_vec3(mesh_.positions[face.corners[k]]);
            mean_radiosity += weight * radiosity[k];
            mean_error += weight * error[k];
        }
        const std::uint32_t middle = add_vertex(centroid, single(mean_radiosity), single(mean_error));
        for (std::size_t n = 0; n < around_.size(); ++n)
            mesh_.faces.push_back({{middle, around_[n], around_[(n + 1) % around_.size()], 0}, 3, face.patch});
    }

    /// The latest vertex at this point of the grid if it has these values, otherwise a new one.
    std::uint32_t vertex(GridPoint point, Float3 radiosity, Float3 error)
    {
        std::uint32_t& latest = latest_.try_emplace(std::uint64_t{point.j} << 32 | point.i, none).first->second;
        if (latest != none && mesh_.radiosity[latest] == radiosity && (!error_ || mesh_.error[latest] == error))
            return latest;
        const Vec3 place = place_of(point);
        latest = add_vertex(is_on_rim(point) ? points_.joined(place, tolerance_) : place, radiosity, error);
        return latest;
    }

    std::uint32_t add_vertex(Vec3 place, Float3 radiosity, Float3 error)
    {
        if (mesh_.positions.size() == std::numeric_limits<std::int32_t>::max())
            throw InputError(scene_.path() + ": too many patches for a mesh, which has less than 2^31 vertices",
                             {{Remedy::patch_size, "", "makes them larger"}});
        mesh_.positions.push_back(single(place));
        mesh_.radiosity.push_back(radiosity);
        if (error_)
            mesh_.error.push_back(error);
        return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
    }

    const Scene& scene_;
    const CornerFunction& radiosity_;
    const CornerFunction& error_;
    std::vector<bool> covered_; ///< per patch
    double tolerance_;          ///< [scene units] between corners that coincide
    PointGrid points_;          ///< corners of patches on the rims of all sides, relative to the origin

    std::uint32_t surface_ = 0; ///< that of the current side
    bool front_ = true;
    std::vector<std::uint32_t> patches_; ///< those of the side that are not covered
    /// True if the side has covered patches or patches of different sizes. Then every edge may be on the rim of a hole,
    /// or have corners of smaller patches on it.
    bool has_inner_rims_ = false;
    std::unordered_map<std::uint64_t, std::uint32_t> latest_; ///< latest vertex per point of the side's grid
    std::vector<std::uint32_t> around_;                       ///< vertices around the current face
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
    return MeshBuilder(scene, radiosity, error, threads).result();
}

} // namespace multipath
