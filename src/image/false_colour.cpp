#include "image/false_colour.h"

#include "base/elementary.h"
#include "base/lists.h"
#include "image/colour_scale.h"
#include "image/shading/smooth_shading.h"
#include "image/tone_map.h"
#include "sampling/random.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace multipath {

std::vector<Rgb> irradiance(const Scene& scene, const std::vector<Rgb>& radiosity)
{
    // For smaller reflectances the rounding error of B - E would be taken for irradiance if the emittance is large.
    constexpr double least_reflectance = 1e-6;
    const auto arriving = [](double b, double e, double rho) {
        // A mean over replicates may be slightly below E because of rounding.
        return rho < least_reflectance ? std::numeric_limits<double>::quiet_NaN() : std::max(0.0, b - e) / rho;
    };
    return serial_list(scene.patch_count(), [&](std::uint32_t i) {
        return by_channel(arriving, radiosity[i], scene.emittance(i), scene.reflectance(i));
    });
}

std::vector<Rgb> magnitudes(const std::vector<Rgb>& values)
{
    return mapped(values, [](Rgb value) { return by_channel([](double x) { return std::abs(x); }, value); });
}

std::vector<Rgb> normal_colours(const Scene& scene)
{
    return serial_list(scene.patch_count(), [&](std::uint32_t i) {
        const Vec3 n = scene.patch(i).shape.normal();
        return srgb_decoded(Rgb{0.5 + 0.5 * n.x, 0.5 + 0.5 * n.y, 0.5 + 0.5 * n.z});
    });
}

std::vector<Rgb> patch_colours(std::size_t patches)
{
    constexpr double chroma = 0.075; // a screen can show all hues of this chroma at these lightnesses
    return serial_list(patches, [&](std::size_t patch) {
        const double angle = 2.0 * pi * bits_to_unit(random_bits(0, 2 * patch));
        const double lightness = 0.45 + 0.39 * bits_to_unit(random_bits(0, 2 * patch + 1));
        return linear_light({lightness, chroma * elementary::cos(angle), chroma * elementary::sin(angle)});
    });
}

// A false-colour picture is made in three steps. The values at the pixel centres tell the range that is visible, from
// which the scale of the legend follows. A render shows every patch in its colour. Contour
// lines are drawn on top: a pixel is covered where the distance to the line, estimated from the difference between its
// value and the contour level divided by the gradient, is below half of the line's width.

namespace {

/// The values at the pixel centres in ascending order, without pixels that show no value.
std::vector<double> sorted_seen_values(const Scene& scene, const std::vector<double>& values,
                                       const std::vector<std::optional<Hit>>& hits)
{
    std::vector<double> seen;
    for (const std::optional<Hit>& hit : hits) {
        if (!hit && scene.file().sky_surfaces == 0)
            continue;
        const std::uint32_t patch =
            hit ? scene.patch_at(hit->surface, hit->u, hit->v, hit->front) : scene.first_patch(scene.own_surfaces());
        if (std::isfinite(values[patch]))
            seen.push_back(values[patch]);
    }
    std::sort(seen.begin(), seen.end());
    return seen;
}

/// The interpolated value at the centre of a pixel.
struct SeenValue
{
    static constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

    std::uint32_t side = nothing; ///< side of a surface; values of different sides are not compared
    double value = 0.0;
};

/// The interpolated values of all pixels, row by row. Sources are left out, so that they get no contour lines.
std::vector<SeenValue> seen_values(const Scene& scene, const std::vector<double>& values,
                                   const std::vector<std::optional<Hit>>& hits, int threads)
{
    std::vector<Rgb> known;
    for (const double value : values)
        known.push_back(std::isfinite(value) ? Rgb{value, value, value} : Rgb{});
    const SmoothShading smooth(scene, known, threads);
    std::vector<SeenValue> seen(hits.size());
    for (std::size_t n = 0; n < hits.size(); ++n) {
        const std::optional<Hit>& hit = hits[n];
        if (hit && scene.surface_material(hit->surface).emittance == Rgb{} &&
            std::isfinite(values[scene.patch_at(hit->surface, hit->u, hit->v, hit->front)]))
            seen[n] = {2 * hit->surface + (hit->front ? 0 : 1), smooth.at(*hit).r};
    }
    return seen;
}

/// Draws contour lines.
class ContourPen
{
public:
    ContourPen(ScreenImage& screen, const std::vector<SeenValue>& seen, const Legend& legend)
        : screen_(screen), seen_(seen), legend_(legend), width_(std::max(1.0, screen.height / 400.0))
    {
    }

    void draw()
    {
        for (int y = 0; y < screen_.height; ++y)
            for (int x = 0; x < screen_.width; ++x)
                if (at(x, y).side != SeenValue::nothing)
                    draw_at(x, y);
    }

private:
    const SeenValue& at(int x, int y) const { return seen_[pixel_index(screen_.width, x, y)]; }

    bool is_same_side(int x, int y, std::uint32_t side) const
    {
        return x >= 0 && y >= 0 && x < screen_.width && y < screen_.height && at(x, y).side == side;
    }

    /// Change of the value per pixel along (step_x, step_y): the central difference, one-sided at the border of a side.
    double slope(int x, int y, int step_x, int step_y) const
    {
        const std::uint32_t side = at(x, y).side;
        const bool before = is_same_side(x - step_x, y - step_y, side);
        const bool after = is_same_side(x + step_x, y + step_y, side);
        if (!before && !after)
            return 0.0;
        const double low = before ? at(x - step_x, y - step_y).value : at(x, y).value;
        const double high = after ? at(x + step_x, y + step_y).value : at(x, y).value;
        return (high - low) / (before && after ? 2.0 : 1.0);
    }

    /// Blends the contour lines near a pixel into it. The coverage is antialiased over one pixel at the line's border.
    void draw_at(int x, int y)
    {
        const double steepness = elementary::hypot(slope(x, y, 1, 0), slope(x, y, 0, 1));
        constexpr double rounding = 1e-9; // share of the scale: even values have no contour
        for (int step = 1; steepness > rounding * legend_.scale.top() && step <= legend_.scale.steps; ++step) {
            const double level = legend_.scale.top() * step / legend_.scale.steps;
            const double cover = 0.5 * width_ + 0.5 - std::abs(at(x, y).value - level) / steepness;
            if (!legend_.has_contour(step) || cover <= 0.0)
                continue;
            for (int channel = 0; channel < 3; ++channel) {
                std::uint8_t& byte = screen_.at(x, y)[channel];
                byte = static_cast<std::uint8_t>(
                    std::lround(byte + std::min(cover, 1.0) * (legend_.contour_grey(step) - byte)));
            }
        }
    }

    ScreenImage& screen_;
    const std::vector<SeenValue>& seen_;
    const Legend& legend_;
    double width_; ///< [pixels]
};

/// The legend for values in ascending order.
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
    options.shading = Shading::flat;
    options.white = std::numeric_limits<double>::infinity();
    const Image image = render(scene, colours, camera, options);
    ScreenImage screen{image.width, image.height, {}};
    screen.bytes.reserve(3 * image.pixels.size());
    // No dithering, unlike tone_map(): a patch must have exactly the colour of the legend.
    for (const Rgb& pixel : image.pixels)
        for (const double channel : {pixel.r, pixel.g, pixel.b})
            screen.bytes.push_back(screen_byte(channel));
    return screen;
}

ScreenImage false_colour(const Scene& scene, const Quantity& quantity, const Camera& camera, RenderOptions options)
{
    const int legend_rows = legend_height(options.width, options.height, quantity.title);
    const Camera view = cropped(camera, options.height, options.height - legend_rows);
    options.height -= legend_rows;
    const std::vector<double> values = mapped(quantity.values, [](Rgb value) { return mean(value); });
    const std::vector<std::optional<Hit>> hits =
        visible_hits(scene, PixelRays(view, options.width, options.height), options.threads);
    Legend legend = legend_for(quantity.title, sorted_seen_values(scene, values, hits));
    legend.contours = quantity.contours;

    std::vector<Rgb> colours;
    for (const double value : values)
        colours.push_back(std::isfinite(value) ? map_colour(value / legend.scale.top()) : Rgb{});
    ScreenImage screen = flat_picture(scene, colours, view, options);
    if (quantity.contours)
        ContourPen(screen, seen_values(scene, values, hits, options.threads), legend).draw();
    if (legend_rows > 0) {
        const ScreenImage strip = legend_strip(options.width, legend_rows, legend);
        screen.bytes.insert(screen.bytes.end(), strip.bytes.begin(), strip.bytes.end());
        screen.height += legend_rows;
    }
    return screen;
}

} // namespace multipath
