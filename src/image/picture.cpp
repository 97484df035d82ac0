#include "image/picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace multipath {

RenderOptions preview_options(RenderOptions options)
{
    const int larger = std::max({options.width, options.height, 1});
    const int shrink = (larger + 159) / 160;
    options.width = std::min(options.width, std::max(1, options.width / shrink));
    options.height = std::min(options.height, std::max(1, options.height / shrink));
    options.samples_per_pixel = 1;
    options.shading = Shading::flat;
    options.white = std::numeric_limits<double>::infinity();
    return options;
}

double picture_scale(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera,
                     const RenderOptions& options, const ToneMapOptions& tone)
{
    const double base = tone.scale
                            ? *tone.scale
                            : automatic_scale(render(scene, radiosity, camera, preview_options(options)), tone.tone);
    return base * std::exp2(tone.exposure);
}

ScreenImage picture(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera,
                    const RenderOptions& options, const ToneMapOptions& tone)
{
    const double scale = picture_scale(scene, radiosity, camera, options, tone);
    RenderOptions clipped = options;
    clipped.white = white_point(tone.tone) / scale;
    return tone_map(render(scene, radiosity, camera, clipped), tone.tone, scale);
}

} // namespace multipath
