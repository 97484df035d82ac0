// The mean of a texture T over a polygon P is an integral over the border of P only (Green's theorem): with
// S(s, t) = integral of T(s', t) ds' from a fixed s to s,
//
//   integral of T over P = integral of S dt around P.
//
// T is constant within a pixel, so S is linear in s there, and along the part of an edge that lies in one pixel the
// midpoint rule is exact. S follows from prefix sums along each row, which are stored for every 4th pixel. Linear
// light is counted in whole units of 1/65535, so sums are exact, and the same on every machine.

#include "scene/texture/texture.h"

#include "base/mix_bits.h"
#include "scene/texture/image_formats.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace multipath {

namespace {

constexpr double unit = 1.0 / 65535.0;

std::array<std::uint16_t, 256> make_linear_table()
{
    std::array<std::uint16_t, 256> table{};
    for (std::size_t k = 0; k < table.size(); ++k) {
        const double linear = srgb_decoded(static_cast<double>(k) / 255.0);
        table[k] = static_cast<std::uint16_t>(std::lround(linear * 65535.0));
    }
    return table;
}

const std::array<std::uint16_t, 256> linear_of_srgb = make_linear_table();

std::uint64_t hash_of(const Bitmap& bitmap, bool repeats)
{
    std::uint64_t hash = mix_bits(std::uint64_t{bitmap.width} << 32 | bitmap.height) ^ (repeats ? 1 : 0);
    for (std::size_t k = 0; k < bitmap.rgb.size(); k += 8) {
        std::uint64_t word = 0;
        for (std::size_t i = k; i < std::min(k + 8, bitmap.rgb.size()); ++i)
            word = word << 8 | bitmap.rgb[i];
        hash = mix_bits(hash ^ word);
    }
    return hash;
}

/// The remainder of a division by n, in 0 ... n - 1 also for negative x.
std::int64_t remainder(std::int64_t x, std::int64_t n)
{
    const std::int64_t r = x % n;
    return r < 0 ? r + n : r;
}

} // namespace

double area_of(const TexturePolygon& p)
{
    double twice = 0.0;
    for (std::size_t k = 2; k < p.size(); ++k)
        twice += (p[k - 1].s - p[0].s) * (p[k].t - p[0].t) - (p[k].s - p[0].s) * (p[k - 1].t - p[0].t);
    return 0.5 * twice;
}

TexturePoint middle_of(const TexturePolygon& polygon)
{
    TexturePoint sum;
    for (const TexturePoint corner : polygon)
        sum = {sum.s + corner.s, sum.t + corner.t};
    const auto n = static_cast<double>(polygon.size());
    return {sum.s / n, sum.t / n};
}

Rgb linear_colour(const std::uint8_t* rgb)
{
    return {unit * linear_of_srgb[rgb[0]], unit * linear_of_srgb[rgb[1]], unit * linear_of_srgb[rgb[2]]};
}

Texture::Texture(std::string name, std::string bytes, bool repeats)
    : name_(std::move(name)),
      bytes_(std::move(bytes)),
      repeats_(repeats),
      bitmap_(read_image(name_, bytes_)),
      hash_(hash_of(bitmap_, repeats))
{
    constexpr auto strip_width = static_cast<std::uint32_t>(Strip::width);
    strips_.resize(std::size_t{(bitmap_.width + strip_width - 1) / strip_width} * bitmap_.height);
    std::array<double, 3> all{};
    for (std::uint32_t y = 0; y < bitmap_.height; ++y) {
        std::array<std::uint32_t, 3> sum{};
        for (std::uint32_t x = 0; x < bitmap_.width; x += strip_width) {
            Strip& strip = strips_[std::size_t{x / strip_width} * bitmap_.height + y];
            strip = {sum, {}};
            const std::size_t used = 3 * std::min(strip_width, bitmap_.width - x);
            std::copy_n(bitmap_.row(y) + 3 * std::size_t{x}, used, strip.rgb.begin());
            for (std::size_t k = 0; k < used; ++k)
                sum[k % 3] += linear_of_srgb[strip.rgb[k]];
        }
        for (std::size_t c = 0; c < 3; ++c)
            all[c] += sum[c];
    }
    const double scale = unit / (static_cast<double>(bitmap_.width) * bitmap_.height);
    mean_ = {scale * all[0], scale * all[1], scale * all[2]};
}

std::int64_t Texture::column(std::int64_t x) const
{
    const std::int64_t width = bitmap_.width;
    return repeats_ ? remainder(x, width) : std::clamp<std::int64_t>(x, 0, width - 1);
}

/// The row of the bitmap, whose first row is at the top, for a row counted from the bottom.
std::uint32_t Texture::row(std::int64_t y) const
{
    const std::int64_t height = bitmap_.height;
    const std::int64_t from_below = repeats_ ? remainder(y, height) : std::clamp<std::int64_t>(y, 0, height - 1);
    return static_cast<std::uint32_t>(height - 1 - from_below);
}

const std::uint8_t* Texture::pixel(std::int64_t x, std::int64_t y) const
{
    return bitmap_.row(row(y)) + 3 * column(x);
}

/// The strip that holds pixel x of a row of the bitmap; the last strip also for x = width.
const Texture::Strip& Texture::strip(std::int64_t x, std::uint32_t row) const
{
    const std::int64_t number = std::min<std::int64_t>(x, bitmap_.width - 1) / Strip::width;
    return strips_[static_cast<std::size_t>(number) * bitmap_.height + row];
}

/// The sums of the pixels 0 ... end - 1 of a row, with end from 0 to the width.
Texture::Sums Texture::sums_within(std::int64_t end, std::uint32_t row) const
{
    const Strip& last = strip(end, row);
    Sums sums = {last.before[0], last.before[1], last.before[2]};
    const std::int64_t first = std::min<std::int64_t>(end, bitmap_.width - 1) / Strip::width * Strip::width;
    const std::uint8_t* pixel = last.rgb.data();
    for (std::int64_t x = first; x < end; ++x, pixel += 3)
        for (std::size_t c = 0; c < 3; ++c)
            sums[c] += linear_of_srgb[pixel[c]];
    return sums;
}

/// The sums of the pixels 0 ... x - 1 of a row. x may lie outside the image, on either side.
Texture::Sums Texture::sums_before(std::int64_t x, std::uint32_t row) const
{
    const std::int64_t width = bitmap_.width;
    if (x >= 0 && x <= width)
        return sums_within(x, row);
    const std::int64_t inside = repeats_ ? remainder(x, width) : std::clamp<std::int64_t>(x, 0, width);
    const std::int64_t beyond = x - inside; // a multiple of the width, or copies of the border pixel
    Sums sums = sums_within(inside, row);
    const Sums row_sums = repeats_ ? sums_within(width, row) : Sums{};
    const std::uint8_t* border = bitmap_.row(row) + 3 * (x < 0 ? 0 : width - 1);
    for (std::size_t c = 0; c < 3; ++c)
        sums[c] += repeats_ ? beyond / width * row_sums[c] : beyond * linear_of_srgb[border[c]];
    return sums;
}

/// Adds the integral of S dt along an edge, pixel by pixel. Coordinates are in pixels; S starts at `first_column`.
void Texture::integrate(TexturePoint from, TexturePoint to, std::int64_t first_column,
                        std::array<double, 3>& sums) const
{
    const double ds = to.s - from.s;
    const double dt = to.t - from.t;
    if (dt == 0.0)
        return;
    const auto next_border = [](double x, double d) { return d > 0.0 ? std::floor(x) + 1.0 : std::ceil(x) - 1.0; };
    double border_s = next_border(from.s, ds);
    double border_t = next_border(from.t, dt);
    double before = 0.0; // parameter along the edge
    std::int64_t row_of_start = std::numeric_limits<std::int64_t>::min();
    Sums start{};
    while (before < 1.0) {
        const double at_s = ds != 0.0 ? (border_s - from.s) / ds : 2.0;
        const double at_t = (border_t - from.t) / dt;
        const double next = std::min({1.0, at_s, at_t});
        const double middle = 0.5 * (before + next);
        const double s = from.s + middle * ds;
        const double t = from.t + middle * dt;
        const auto x = static_cast<std::int64_t>(std::floor(s));
        const auto y = static_cast<std::int64_t>(std::floor(t));
        const std::uint32_t in_row = row(y);
        if (y != std::exchange(row_of_start, y))
            start = sums_before(first_column, in_row);
        const Sums here = sums_before(x, in_row);
        const std::int64_t column_under = column(x);
        const std::uint8_t* under =
            &strip(column_under, in_row).rgb[static_cast<std::size_t>(3 * (column_under % Strip::width))];
        for (std::size_t c = 0; c < 3; ++c)
            sums[c] +=
                (next - before) * dt *
                (static_cast<double>(here[c] - start[c]) + (s - static_cast<double>(x)) * linear_of_srgb[under[c]]);
        if (at_s <= next)
            border_s += ds > 0.0 ? 1.0 : -1.0;
        if (at_t <= next)
            border_t += dt > 0.0 ? 1.0 : -1.0;
        before = next;
    }
}

Rgb Texture::mean(TexturePolygon p) const
{
    const double width = bitmap_.width;
    const double height = bitmap_.height;
    // A repeating texture may be shifted by whole periods, towards the origin, where numbers are more precise.
    const double shift_s = repeats_ ? std::floor(p[0].s) : 0.0;
    const double shift_t = repeats_ ? std::floor(p[0].t) : 0.0;
    double length = 0.0;
    double farthest = 0.0;
    for (TexturePoint& corner : p) {
        corner = {width * (corner.s - shift_s), height * (corner.t - shift_t)};
        farthest = std::max({farthest, std::abs(corner.s), std::abs(corner.t)});
    }
    double least = p[0].s;
    TexturePoint before = p.back();
    for (const TexturePoint corner : p) {
        least = std::min(least, corner.s);
        length += std::abs(before.s - corner.s) + std::abs(before.t - corner.t);
        before = corner;
    }
    constexpr double too_long = 1e6; // [pixels] along the border: the mean of so many is that of the texture
    constexpr double too_far = 1e13; // [pixels] from a texture that does not repeat: sums have 64 bits
    if (!(length < too_long && farthest < too_far))
        return mean_;
    const double area = area_of(p);
    constexpr double no_area = 1e-9; // [pixels]
    if (std::abs(area) < no_area) {
        const TexturePoint middle = middle_of(p);
        return linear_colour(
            pixel(static_cast<std::int64_t>(std::floor(middle.s)), static_cast<std::int64_t>(std::floor(middle.t))));
    }
    std::array<double, 3> sums{};
    for (std::size_t k = 0; k < p.size(); ++k)
        integrate(p[k], p[(k + 1) % p.size()], static_cast<std::int64_t>(std::floor(least)), sums);
    const auto channel = [&](std::size_t c) { return std::clamp(unit * sums[c] / area, 0.0, 1.0); };
    return {channel(0), channel(1), channel(2)};
}

Rgb texture_mean(const Texture& texture, const TextureFrame& frame, const std::vector<std::array<double, 2>>& uv)
{
    if (!frame.known)
        return texture.mean();
    TexturePolygon polygon;
    for (const auto [u, v] : uv)
        polygon.push_back(frame.at(u, v));
    return texture.mean(std::move(polygon));
}

Rgb Texture::at(TexturePoint point) const
{
    const double s = (repeats_ ? point.s - std::floor(point.s) : std::clamp(point.s, 0.0, 1.0)) * bitmap_.width - 0.5;
    const double t = (repeats_ ? point.t - std::floor(point.t) : std::clamp(point.t, 0.0, 1.0)) * bitmap_.height - 0.5;
    const double x = std::floor(s);
    const double y = std::floor(t);
    const auto corner = [&](int right, int up) {
        return linear_colour(pixel(static_cast<std::int64_t>(x) + right, static_cast<std::int64_t>(y) + up));
    };
    const double a = s - x;
    const double b = t - y;
    return (1.0 - b) * ((1.0 - a) * corner(0, 0) + a * corner(1, 0)) +
           b * ((1.0 - a) * corner(0, 1) + a * corner(1, 1));
}

} // namespace multipath
