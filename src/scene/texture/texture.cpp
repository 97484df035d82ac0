// The mean of a texture T over a polygon P is an integral over the border of P only (Green's theorem): with
// S(s, t) = integral of T(s', t) ds' from a fixed s to s,
//
//   integral of T over P = integral of S dt around P.
//
// T is constant within a pixel, so S is linear in s there, and along the part of an edge that lies in one pixel the
// midpoint rule is exact. S follows from prefix sums along each row, which are stored for every 4th pixel. Along an
// upright edge, as most patches have, the rows add up to differences of a summed-area table (Crow 1984), stored for
// every 8th row. Linear light is counted in whole units of 1/65535, so sums are exact, and the same on every machine.

#include "scene/texture/texture.h"

#include "base/lists.h"
#include "base/mix_bits.h"

#include <algorithm>
#include <cmath>
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

void add(std::array<std::int64_t, 3>& sums, std::int64_t factor, const std::array<std::int64_t, 3>& more)
{
    for (std::size_t c = 0; c < 3; ++c)
        sums[c] += factor * more[c];
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
    strips_.resize(static_cast<std::size_t>((bitmap_.width + Strip::width - 1) / Strip::width) * bitmap_.height);
    std::array<double, 3> all{};
    for (std::uint32_t y = 0; y < bitmap_.height; ++y) {
        std::array<std::uint32_t, 3> sum{};
        for (std::uint32_t x = 0; x < bitmap_.width; ++x) {
            Strip& strip = strips_[x / Strip::width * bitmap_.height + y];
            if (x % Strip::width == 0)
                strip.before = sum;
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint8_t level = bitmap_.row(y)[3 * std::size_t{x} + c];
                strip.rgb[3 * (x % Strip::width) + c] = level;
                sum[c] += linear_of_srgb[level];
            }
        }
        for (std::size_t c = 0; c < 3; ++c)
            all[c] += sum[c];
    }
    const double scale = unit / (static_cast<double>(bitmap_.width) * bitmap_.height);
    mean_ = {scale * all[0], scale * all[1], scale * all[2]};
    add_up_columns();
}

void Texture::add_up_columns()
{
    const std::size_t blocks = bitmap_.height / std::size_t{rows_per_block} + 1;
    below_.assign((std::size_t{bitmap_.width} + 1) * blocks, Sums{});
    std::vector<Sums> sums(std::size_t{bitmap_.width} + 1); // of the rows so far, before each column
    for (std::uint32_t y = 0; y < bitmap_.height; ++y) {
        const std::uint8_t* rgb = bitmap_.row(bitmap_.height - 1 - y);
        Sums before{};
        for (std::size_t x = 0; x <= bitmap_.width; ++x, rgb += 3) {
            if (y % rows_per_block == 0)
                below_[x * blocks + y / rows_per_block] = sums[x];
            for (std::size_t c = 0; c < 3; ++c) {
                sums[x][c] += before[c];
                before[c] += x < bitmap_.width ? linear_of_srgb[rgb[c]] : 0;
            }
        }
    }
    if (bitmap_.height % rows_per_block == 0)
        for (std::size_t x = 0; x <= bitmap_.width; ++x)
            below_[x * blocks + blocks - 1] = sums[x];
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

/// The sums of the pixels 0 ... end - 1 of a row, with end from 0 to the width.
Texture::Sums Texture::sums_within(std::int64_t end, std::uint32_t row) const
{
    const std::size_t last = std::min(static_cast<std::size_t>(end), std::size_t{bitmap_.width} - 1) / Strip::width;
    const Strip& strip = strips_[last * bitmap_.height + row];
    Sums sums = {strip.before[0], strip.before[1], strip.before[2]};
    for (std::size_t k = 0; k < 3 * (static_cast<std::size_t>(end) - last * Strip::width); ++k)
        sums[k % 3] += linear_of_srgb[strip.rgb[k]];
    return sums;
}

/// Sums over the image as it continues outside: those before `at`, where sums_before(end) are those of the image itself
/// before `end`, from 0 to `size`. Outside, they are a linear function of the number of whole images, or of copies of
/// the border.
template <class SumsBefore>
Texture::Sums Texture::continued(std::int64_t at, std::int64_t size, const SumsBefore& sums_before) const
{
    if (at >= 0 && at <= size)
        return sums_before(at);
    const std::int64_t inside = repeats_ ? remainder(at, size) : std::clamp<std::int64_t>(at, 0, size);
    const std::int64_t periods = repeats_ ? (at - inside) / size : at - inside;
    const std::int64_t from = repeats_ || at < 0 ? 0 : size - 1; // a period, or a pixel at the border, is [from, to)
    const std::int64_t to = repeats_ || at > 0 ? size : 1;
    Sums period = sums_before(to);
    add(period, -1, sums_before(from));
    Sums sums = sums_before(inside);
    add(sums, periods, period);
    return sums;
}

/// The sums of the pixels 0 ... x - 1 of a row. x may lie outside the image, on either side.
Texture::Sums Texture::sums_before(std::int64_t x, std::uint32_t row) const
{
    return continued(x, bitmap_.width, [&](std::int64_t end) { return sums_within(end, row); });
}

/// The sums of the pixels in columns 0 ... x - 1 and rows 0 ... y - 1, counted from below, of the image itself.
Texture::Sums Texture::sums_of_corner(std::int64_t x, std::int64_t y) const
{
    const std::int64_t blocks = bitmap_.height / rows_per_block + 1;
    Sums sums = below_[static_cast<std::size_t>(x * blocks + y / rows_per_block)];
    for (std::int64_t k = y / rows_per_block * rows_per_block; k < y; ++k)
        add(sums, 1, sums_within(x, row(k)));
    return sums;
}

/// The same for any x and y, of the image as it continues outside.
Texture::Sums Texture::sums_below(std::int64_t x, std::int64_t y) const
{
    return continued(x, bitmap_.width, [&](std::int64_t column) {
        return continued(y, bitmap_.height, [&](std::int64_t row) { return sums_of_corner(column, row); });
    });
}

/// Linear light of a pixel, which may lie outside the image, in a row of the bitmap.
Texture::Sums Texture::light(std::int64_t x, std::uint32_t row) const
{
    const auto inside = static_cast<std::size_t>(column(x));
    const Strip& strip = strips_[inside / Strip::width * bitmap_.height + row];
    const std::uint8_t* rgb = &strip.rgb[3 * (inside % Strip::width)];
    return {linear_of_srgb[rgb[0]], linear_of_srgb[rgb[1]], linear_of_srgb[rgb[2]]};
}

/// Adds the integral of S dt along an edge. Coordinates are in pixels; S starts at `first_column`, which is not to the
/// right of the edge.
void Texture::integrate(TexturePoint from, TexturePoint to, std::int64_t first_column,
                        std::array<double, 3>& sums) const
{
    constexpr double many_rows = 16.0;
    constexpr double far = 0x1p20; // sums of so many pixels in both directions fit into 64 bits
    if (from.s == to.s && std::abs(to.t - from.t) >= many_rows && std::abs(from.s) < far && std::abs(from.t) < far &&
        std::abs(to.t) < far)
        integrate_upright(from.s, from.t, to.t, first_column, sums);
    else if (from.t != to.t)
        integrate_slanted(from, to, first_column, sums);
}

/// An edge along which s is constant: S is constant within a row, and differences of sums_below() add up its rows.
void Texture::integrate_upright(double s, double from_t, double to_t, std::int64_t first_column,
                                std::array<double, 3>& sums) const
{
    const auto x = static_cast<std::int64_t>(std::floor(s));
    const double within = s - static_cast<double>(x);
    const auto first = static_cast<std::int64_t>(std::floor(from_t));
    const auto last = static_cast<std::int64_t>(std::floor(to_t));
    const auto add_part_of_row = [&](std::int64_t y, double height) { // [rows]
        Sums before = sums_before(x, row(y));
        add(before, -1, sums_before(first_column, row(y)));
        const Sums under = light(x, row(y));
        for (std::size_t c = 0; c < 3; ++c)
            sums[c] += height * (static_cast<double>(before[c]) + within * static_cast<double>(under[c]));
    };
    const auto add_whole_rows = [&](std::int64_t column, double factor) {
        Sums rows = sums_below(column, last);
        add(rows, -1, sums_below(first_column, last));
        add(rows, -1, sums_below(column, first));
        add(rows, 1, sums_below(first_column, first));
        for (std::size_t c = 0; c < 3; ++c)
            sums[c] += factor * static_cast<double>(rows[c]);
    };
    add_whole_rows(x, 1.0 - within);
    add_whole_rows(x + 1, within);
    add_part_of_row(last, to_t - static_cast<double>(last));
    add_part_of_row(first, static_cast<double>(first) - from_t);
}

/// Any edge, row by row, and within a row pixel by pixel.
void Texture::integrate_slanted(TexturePoint from, TexturePoint to, std::int64_t first_column,
                                std::array<double, 3>& sums) const
{
    const double ds = to.s - from.s;
    const double dt = to.t - from.t;
    // The pixel that the edge is in after x, or before it.
    const auto pixel_after = [](double x, double d) {
        return static_cast<std::int64_t>(d > 0.0 ? std::floor(x) : std::ceil(x) - 1.0);
    };
    const std::int64_t up = dt > 0.0 ? 1 : -1;
    const std::int64_t right = ds > 0.0 ? 1 : -1;
    std::int64_t y = pixel_after(from.t, dt);
    double s = from.s;
    for (double before = 0.0; before < 1.0; y += up) { // parameter along the edge
        const double border = static_cast<double>(dt > 0.0 ? y + 1 : y);
        const double next = std::min(1.0, std::max(before, (border - from.t) / dt));
        const double end = from.s + next * ds;
        const double height = (next - before) * dt;
        const std::uint32_t in_row = row(y);
        const std::int64_t last = pixel_after(end, -ds);
        std::int64_t x = ds != 0.0 ? pixel_after(s, ds) : last;
        Sums sum = sums_before(x, in_row);
        add(sum, -1, sums_before(first_column, in_row));
        const double rows_per_column = (last - x) * right > 0 ? height / (end - s) : 0.0;
        for (double rows_left = height;; x += right) {
            const bool ends = (last - x) * right <= 0;
            const double leaves = ends ? end : static_cast<double>(ds > 0.0 ? x + 1 : x);
            const double rows = ends ? rows_left : (leaves - s) * rows_per_column;
            const double within = 0.5 * (s + leaves) - static_cast<double>(x);
            const Sums under = light(x, in_row);
            for (std::size_t c = 0; c < 3; ++c)
                sums[c] += rows * (static_cast<double>(sum[c]) + within * static_cast<double>(under[c]));
            if (ends)
                break;
            rows_left -= rows;
            s = leaves;
            add(sum, right, ds > 0.0 ? under : light(x - 1, in_row));
        }
        s = end;
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
    return texture.mean(mapped(uv, [&](const std::array<double, 2>& at) { return frame.at(at[0], at[1]); }));
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
