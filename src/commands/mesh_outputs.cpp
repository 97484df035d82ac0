#include "commands/mesh_outputs.h"

#include "export/glb.h"
#include "export/linear_scale.h"
#include "export/obj_colours.h"
#include "export/ply.h"
#include "image/picture.h"
#include "image/smooth_shading.h"
#include "image/srgb.h"
#include "scene/text_format.h"

#include <cmath>

namespace multipath {

namespace {

PatchMesh mesh_of(const Scene& scene, const Solution& solution, Shading shading, int threads)
{
    const bool has_error = !solution.standard_error.empty();
    if (shading == Shading::flat)
        return patch_mesh(scene, flat_corners(solution.radiosity),
                          has_error ? flat_corners(solution.standard_error) : CornerFunction(), threads);
    const auto corners_of = [](const SmoothShading& smooth) {
        return [&smooth](std::uint32_t patch) { return smooth.at_corners(patch); };
    };
    const SmoothShading radiosity(scene, solution.radiosity, threads);
    if (!has_error)
        return patch_mesh(scene, corners_of(radiosity), {}, threads);
    const SmoothShading error(scene, solution.standard_error, threads);
    return patch_mesh(scene, corners_of(radiosity), corners_of(error), threads);
}

} // namespace

bool is_mesh(OutputFormat format)
{
    return format == OutputFormat::ply || format == OutputFormat::glb || format == OutputFormat::obj;
}

SolvedMesh::SolvedMesh(const Scene& scene, const Solution& solution, const PictureOptions& options)
    : scene_(scene),
      solution_(solution),
      options_(options),
      mesh_(mesh_of(scene, solution, options.mesh_shading, options.render.threads))
{
}

std::string SolvedMesh::bytes(OutputFormat format, std::vector<std::string> comments) const
{
    const ToneMapOptions& tone = options_.tone;
    if (format == OutputFormat::glb) {
        const double scale = std::exp2(tone.exposure) * linear_scale(scene_, solution_.radiosity);
        return glb_bytes(mesh_, scene_, scale, comments);
    }
    const double scale =
        picture_scale(scene_, solution_.radiosity, camera_for(scene_, options_), options_.render, tone);
    const ScreenColour colour = [&](Rgb radiosity) { return srgb_encoded(screen_light(radiosity, tone.tone, scale)); };
    comments.push_back(multipath::format("colours: sRGB after the tone map of %.17g m^2/W * radiosity", scale));
    if (format == OutputFormat::ply)
        return ply_bytes(mesh_, solution_.radiosity, colour, comments);
    return obj_text(mesh_, scene_, colour, comments);
}

} // namespace multipath
