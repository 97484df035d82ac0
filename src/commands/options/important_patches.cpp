#include "commands/options/important_patches.h"

#include "cli/options/usage_error.h"
#include "scene/input_error.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace multipath {

namespace {

/// Adds what one camera sees: the pixels of each patch over its area.
void add_view(const Scene& scene, const Camera& camera, double aspect, std::vector<double>& weight)
{
    constexpr int rows = 256;
    const int columns = std::clamp(static_cast<int>(aspect * rows), 1, 4096);
    const PixelRays rays(camera, columns, rows);
    VisibleHits visible(scene);
    for (int y = 0; y < rows; ++y)
        for_each_visible(rays, columns, y, visible, [&](int, const std::optional<Hit>& hit) {
            if (!hit)
                return;
            const std::uint32_t patch = scene.patch_at(hit->surface, hit->u, hit->v, hit->front);
            if (patch != Scene::no_patch)
                weight[patch] += 1.0 / scene.area(patch);
        });
}

std::vector<double> weight_of_views(const Scene& scene, const PictureOptions& pictures)
{
    if (!pictures.eye || !pictures.target)
        throw UsageError("--important view: the view must be known before the light; expected --eye and --target, or "
                         "--camera");
    std::vector<double> weight(scene.patch_count());
    const double aspect = static_cast<double>(pictures.render.width) / pictures.render.height;
    if (pictures.views.empty())
        add_view(scene, camera_for(scene, pictures), aspect, weight);
    for (const View& view : pictures.views)
        add_view(scene, view.camera, aspect, weight);
    return weight;
}

std::vector<double> weight_of_named(const Scene& scene, const std::string& name)
{
    const SceneFile& file = scene.file();
    std::vector<double> weight(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const std::uint32_t surface = scene.surface_of(i);
        if (!scene.is_sky(surface) && (file.groups[file.group[surface]] == name || scene.material_of(i).name == name))
            weight[i] = 1.0;
    }
    if (std::find(weight.begin(), weight.end(), 1.0) == weight.end())
        throw InputError(scene.path() + ": --important: no object or material is called '" + name +
                         "'; 'multipath check' lists them");
    return weight;
}

} // namespace

std::shared_ptr<const Importance> important_patches(const Scene& scene, const std::string& what,
                                                    const PictureOptions& pictures)
{
    if (what.empty())
        throw UsageError("--important: expected the name of an object or a material, or view");
    Importance importance;
    importance.weight = what == "view" ? weight_of_views(scene, pictures) : weight_of_named(scene, what);
    double largest = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        largest = std::max(largest, mean(scene.reflectance(i)) > 0.0 ? importance.weight[i] : 0.0);
    if (!(largest > 0.0))
        throw InputError(scene.path() + ": --important " + what + ": nothing there reflects light");
    for (double& weight : importance.weight)
        weight /= largest;
    return std::make_shared<const Importance>(std::move(importance));
}

} // namespace multipath
