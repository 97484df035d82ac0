// Radiosity is multiplied by a scale (exposure), mapped by a tone curve, encoded as sRGB and rounded to 8 bits with
// ordered dithering. The curve is applied per channel, so that very bright colours fade to white as on film. Reinhard's
// curve is equation (4) of Reinhard et al., Photographic Tone Reproduction, SIGGRAPH 2002. The film curve is the fit by
// Narkowicz (2015) to the reference curve of the Academy Color Encoding System.

#include "image/tone_map.h"

#include "base/elementary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace multipath {

double srgb_encoded(double linear)
{
    if (!(linear > 0.0))
        return 0.0;
    if (linear >= 1.0)
        return 1.0;
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * elementary::pow(linear, 1.0 / 2.4) - 0.055;
}

Rgb srgb_encoded(Rgb linear)
{
    return by_channel([](double channel) { return srgb_encoded(channel); }, linear);
}

Rgb srgb_decoded(Rgb encoded)
{
    return by_channel([](double channel) { return srgb_decoded(channel); }, encoded);
}

std::uint8_t screen_byte(double linear)
{
    return static_cast<std::uint8_t>(255.0 * srgb_encoded(linear) + 0.5);
}

namespace {

constexpr double middle_grey = 0.24;   // linear light on the screen of the room's mid-tones
constexpr double reinhard_white = 2.0; // three stops above the mid-tones

double curve(ToneOperator tone, double x)
{
    switch (tone) {
    case ToneOperator::reinhard:
        return x * (1.0 + x / (reinhard_white * reinhard_white)) / (1.0 + x);
    case ToneOperator::aces:
        return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
    case ToneOperator::linear:
    case ToneOperator::percentile:
        break;
    }
    return x;
}

/// The input for which the increasing curve gives `output`, by bisection in [0, 16].
double inverse_curve(ToneOperator tone, double output)
{
    double low = 0.0;
    double high = 16.0;
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + high);
        (curve(tone, middle) < output ? low : high) = middle;
    }
    return high;
}

/// Rec. 709 luminances of the pixels that are not black, in ascending order.
std::vector<double> sorted_luminances(const std::vector<Rgb>& pixels)
{
    std::vector<double> luminances;
    for (const Rgb& pixel : pixels) {
        const double luminance = 0.2126 * pixel.r + 0.7152 * pixel.g + 0.0722 * pixel.b;
        if (luminance > 0.0 && std::isfinite(luminance))
            luminances.push_back(luminance);
    }
    std::sort(luminances.begin(), luminances.end());
    return luminances;
}

/// Interquartile geometric mean of the luminances: less noisy than the median, and as robust to lamps and dark corners.
double middle_luminance(const std::vector<double>& sorted)
{
    const std::size_t first = sorted.size() / 4;
    const std::size_t last = std::max(first + 1, sorted.size() - first);
    double sum = 0.0;
    for (std::size_t i = first; i < last; ++i)
        sum += elementary::log(sorted[i]);
    return elementary::exp(sum / static_cast<double>(last - first));
}

/// The 98th percentile of the luminances up to ten times the middle one; brighter pixels are taken for lamps.
double brightest_of_room(const std::vector<double>& sorted)
{
    const auto lamps = std::upper_bound(sorted.begin(), sorted.end(), 10.0 * middle_luminance(sorted));
    const auto count = static_cast<std::size_t>(lamps - sorted.begin());
    return sorted[std::max<std::size_t>(count, 1) * 98 / 100];
}

/// Threshold of a pixel in [0, 1) for ordered dithering over squares of 8 x 8 pixels (Bayer 1973): low and high
/// thresholds are balanced in every half, quarter ... of the square. Random thresholds look no better, but cannot be
/// compressed; a pattern repeats in a PNG.
double dither_threshold(int x, int y)
{
    int threshold = 0; // 0 ... 63
    for (int bit = 0; bit < 3; ++bit) {
        const int from_x = x >> bit & 1;
        const int from_y = y >> bit & 1;
        threshold |= ((from_x ^ from_y) << 1 | from_y) << 2 * (2 - bit);
    }
    return (threshold + 0.5) / 64.0;
}

std::uint8_t quantized(double linear, double threshold)
{
    const double encoded = srgb_encoded(linear);
    // Black and white are not dithered: a pattern there would look like dirt.
    const double dither = encoded > 0.0 && encoded < 1.0 ? threshold - 0.5 : 0.0;
    return static_cast<std::uint8_t>(std::clamp(255.0 * encoded + dither + 0.5, 0.0, 255.0));
}

} // namespace

double white_point(ToneOperator tone)
{
    return inverse_curve(tone, 1.0);
}

double automatic_scale(const std::vector<Rgb>& pixels, ToneOperator tone)
{
    const std::vector<double> luminances = sorted_luminances(pixels);
    if (luminances.empty())
        return 1.0;
    if (tone == ToneOperator::percentile)
        return 1.0 / brightest_of_room(luminances);
    return inverse_curve(tone, middle_grey) / middle_luminance(luminances);
}

double largest_scale(const std::vector<Rgb>& pixels, ToneOperator tone, double white_share)
{
    const std::vector<double> luminances = sorted_luminances(pixels);
    if (luminances.empty())
        return std::numeric_limits<double>::infinity();
    const auto white = static_cast<std::size_t>(white_share * static_cast<double>(luminances.size()));
    return white_point(tone) / luminances[luminances.size() - 1 - white];
}

Rgb screen_light(Rgb radiosity, ToneOperator tone, double scale)
{
    const auto shown = [&](double channel) {
        const double light = curve(tone, scale * channel);
        return light > 0.0 ? std::min(light, 1.0) : 0.0; // NaN becomes black
    };
    return by_channel(shown, radiosity);
}

ScreenImage tone_map(const Image& image, ToneOperator tone, double scale)
{
    ScreenImage screen{image.width, image.height, {}};
    screen.bytes.reserve(3 * image.pixels.size());
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double threshold = dither_threshold(x, y);
            const Rgb light = screen_light(image.at(x, y), tone, scale);
            for (const double channel : {light.r, light.g, light.b})
                screen.bytes.push_back(quantized(channel, threshold));
        }
    return screen;
}

} // namespace multipath
