// The colour map is a polyline with segments of equal length in OKLab (B. Ottosson, A perceptual color space for image
// processing, 2020), in which equal distances look about equally large: a step of the value looks the same anywhere on
// the scale. From blue to yellow it passes through purple and orange but not green, so that no two of its colours
// differ only in red against green.

#include "image/false_colour/colour_map.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace multipath {

namespace {

constexpr std::array<OkLab, 7> milestones = {{{0.340, 0.030, -0.142},
                                              {0.452, 0.101, -0.129},
                                              {0.555, 0.153, -0.065},
                                              {0.654, 0.153, 0.021},
                                              {0.749, 0.110, 0.102},
                                              {0.850, 0.030, 0.130},
                                              {0.960, -0.037, 0.114}}};

double cube(double x)
{
    return x * x * x;
}

double between(double a, double b, double share)
{
    return a + share * (b - a);
}

} // namespace

Rgb linear_light(OkLab colour)
{
    const auto [lightness, a, b] = colour;
    const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

Rgb map_colour(double share)
{
    const double position = std::clamp(share, 0.0, 1.0) * static_cast<double>(milestones.size() - 1);
    const std::size_t segment = std::min(static_cast<std::size_t>(position), milestones.size() - 2);
    const double rest = position - static_cast<double>(segment);
    const OkLab from = milestones[segment];
    const OkLab to = milestones[segment + 1];
    return linear_light({between(from.lightness, to.lightness, rest), between(from.green_red, to.green_red, rest),
                         between(from.blue_yellow, to.blue_yellow, rest)});
}

} // namespace multipath
