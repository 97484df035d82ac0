#include "image/exposure.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace multipath {

double automatic_exposure(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera,
                          const RenderOptions& options, ToneOperator tone)
{
    constexpr double most_white = 0.125; // share of the surfaces in the picture
    const RenderOptions small = preview_options(options);
    std::vector<Rgb> all;
    std::vector<Rgb> lit; // those that do not emit
    for (const std::optional<Hit>& hit :
         visible_hits(scene, PixelRays(camera, small.width, small.height), options.threads)) {
        if (!hit || scene.is_sky(hit->surface))
            continue;
        const std::uint32_t patch = scene.patch_at(hit->surface, hit->u, hit->v, hit->front);
        if (radiosity[patch] == Rgb{})
            continue;
        all.push_back(radiosity[patch]);
        if (scene.emittance(patch) == Rgb{})
            lit.push_back(radiosity[patch]);
    }
    return std::min(automatic_scale(all, tone), largest_scale(lit, tone, most_white));
}

} // namespace multipath
