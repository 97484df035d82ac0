#include "image/false_colour/false_colour.h"

#include "image/false_colour/colour_map.h"
#include "image/false_colour/legend.h"
#include "image/tone_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace multipath {

namespace {

/// The values at the middles of the pixels, in ascending order.
std::vector<double> sorted_seen_values(const Scene& scene, const std::vector<double>& values, const Camera& camera,
                                       RenderOptions options)
{
    // The second channel distinguishes a value of 0 from no value.
    std::vector<Rgb> marked;
    marked.reserve(values.size());
    for (const double value : values)
        marked.push_back(std::isfinite(value) ? Rgb{value, 1.0, 0.0} : Rgb{});
    options.samples_per_pixel = 1;
    std::vector<double> seen;
    for (const Rgb& pixel : render(scene, marked, camera, options).pixels)
        if (pixel.g > 0.0)
            seen.push_back(pixel.r);
    std::sort(seen.begin(), seen.end());
    return seen;
}

RenderOptions flat(RenderOptions options)
{
    options.shading = Shading::flat;
    options.white = std::numeric_limits<double>::infinity();
    return options;
}

/// The scale for values in rising order, and whether it leaves some out.
Legend legend_for(const std::string& title, const std::vector<double>& sorted)
{
    if (sorted.empty())
        return {title, round_scale(0.0)};
    const double most = sorted[(sorted.size() - 1) * 99 / 100];
    const double usual = sorted[(sorted.size() - 1) * 9 / 10];
    const LegendScale scale = round_scale(usual > 0.0 ? std::min(most, 2.0 * usual) : most);
    return {title, scale, sorted.back() > scale.top()};
}

} // namespace

ScreenImage flat_picture(const Scene& scene, const std::vector<Rgb>& colours, const Camera& camera,
                         RenderOptions options)
{
    const Image image = render(scene, colours, camera, flat(options));
    ScreenImage screen{image.width, image.height, {}};
    screen.bytes.reserve(3 * image.pixels.size());
    // No dither as in tone_map: a patch is to be of one colour, the legend's.
    for (const Rgb& pixel : image.pixels)
        for (const double channel : {pixel.r, pixel.g, pixel.b})
            screen.bytes.push_back(screen_byte(channel));
    return screen;
}

ScreenImage false_colour(const Scene& scene, const Quantity& quantity, const Camera& camera, RenderOptions options)
{
    const int strip_height = legend_height(options.width, options.height, quantity.title);
    const Camera view = cropped(camera, options.height, options.height - strip_height);
    options.height -= strip_height;
    std::vector<double> values;
    values.reserve(quantity.values.size());
    for (const Rgb& value : quantity.values)
        values.push_back(mean(value));
    const Legend legend = legend_for(quantity.title, sorted_seen_values(scene, values, view, flat(options)));

    std::vector<Rgb> colours;
    colours.reserve(values.size());
    for (const double value : values)
        colours.push_back(std::isfinite(value) ? map_colour(value / legend.scale.top()) : Rgb{});
    ScreenImage screen = flat_picture(scene, colours, view, options);
    if (strip_height > 0) {
        const ScreenImage strip = legend_strip(options.width, strip_height, legend);
        screen.bytes.insert(screen.bytes.end(), strip.bytes.begin(), strip.bytes.end());
        screen.height += strip_height;
    }
    return screen;
}

} // namespace multipath
