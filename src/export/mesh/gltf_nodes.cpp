#include "export/mesh/gltf_nodes.h"

#include "base/elementary.h"
#include "export/mesh/patch_mesh.h"

#include <array>
#include <numeric>

namespace multipath {

namespace {

/// The matrix of a node, column by column.
std::vector<double> node_matrix(const std::array<Vec3, 3>& axes, Vec3 place)
{
    std::vector<double> matrix;
    for (const Vec3 column : {axes[0], axes[1], axes[2], place})
        matrix.insert(matrix.end(), {column.x, column.y, column.z, 0.0});
    matrix.back() = 1.0;
    return matrix;
}

/// Matrix from camera coordinates, in which the camera looks along -z, to scene coordinates relative to `origin`.
std::vector<double> matrix_of(const GlbCamera& camera, Vec3 origin)
{
    const Vec3 back = normalized(camera.eye - camera.target);
    const Vec3 right = normalized(cross(camera.up, back));
    return node_matrix({right, cross(back, right), back}, camera.eye - origin);
}

/// Where a rotation that turns `up` to y takes the axes x, y and z. Exact if `up` is one of them.
std::array<Vec3, 3> turned_upright(Vec3 up)
{
    Vec3 u = normalized(up);
    const double turn =
        u.y < 0.0 ? -1.0 : 1.0; // half a turn about x first: rotations by almost 180 degrees are inexact
    u = {u.x, turn * u.y, turn * u.z};
    const Vec3 axis = {-u.z, 0.0, u.x}; // u x y; its length is the sine of the angle
    const auto turned = [&](Vec3 p) {   // Rodrigues' formula
        return u.y * p + cross(axis, p) + (dot(axis, p) / (1.0 + u.y)) * axis + Vec3{}; // never -0
    };
    return {turned({1.0, 0.0, 0.0}), turned({0.0, turn, 0.0}), turned({0.0, 0.0, turn})};
}

JsonObject glb_camera(const GlbCamera& camera, const Scene& scene)
{
    constexpr double near = 0.002; // share of the scene's diagonal
    return JsonObject()
        .text("type", "perspective")
        .object("perspective", JsonObject()
                                   .number("yfov", camera.field_of_view * pi / 180.0)
                                   .number("znear", near * scene.bounds().diagonal()));
}

} // namespace

GlbNodes glb_nodes(const Scene& scene, const std::vector<std::string>& mesh_names,
                   const std::vector<GlbCamera>& cameras, Vec3 up)
{
    const Vec3 origin = mesh_origin(scene);
    GlbNodes result;
    for (const std::string& name : mesh_names)
        result.nodes.push_back(JsonObject().text("name", name).count("mesh", result.nodes.size()));
    for (const GlbCamera& camera : cameras) {
        result.nodes.push_back(JsonObject()
                                   .text("name", camera.name)
                                   .count("camera", result.cameras.size())
                                   .numbers("matrix", matrix_of(camera, origin)));
        result.cameras.push_back(glb_camera(camera, scene));
    }
    result.roots.resize(result.nodes.size());
    std::iota(result.roots.begin(), result.roots.end(), 0.0);
    const std::array<Vec3, 3> axes = turned_upright(up);
    if (origin != Vec3{} || axes[1] != Vec3{0.0, 1.0, 0.0}) {
        const Vec3 place = origin.x * axes[0] + origin.y * axes[1] + origin.z * axes[2];
        result.nodes.push_back(JsonObject()
                                   .text("name", "scene")
                                   .numbers("matrix", node_matrix(axes, place))
                                   .numbers("children", result.roots));
        result.roots = {static_cast<double>(result.nodes.size() - 1)};
    }
    return result;
}

} // namespace multipath
