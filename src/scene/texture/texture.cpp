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
            const std::size_t used = std::size_t{3} * std::min(strip_width, bitmap_.width - x);
            std::copy_n(bitmap_.row(y) + 3 * std::size_t{x}, used, strip.rgb.begin());
            for (std::size_t k = 0; k < used; ++k)
                sum[k % 3] += linear_of_srgb[strip.rgb[k]];
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

/// The sums of the pixels in columns 0 ... x - 1 and rows 0 ... y - 1, counted from below, of the image itself.
Texture::Sums Texture::sums_of_corner(std::int64_t x, std::int64_t y) const
{
    const std::int64_t blocks = bitmap_.height / rows_per_block + 1;
    Sums sums = below_[static_cast<std::size_t>(x * blocks + y / rows_per_block)];
    for (std::int64_t k = y / rows_per_block * rows_per_block; k < y; ++k) {
        const Sums in_row = sums_within(x, row(k));
        for (std::size_t c = 0; c < 3; ++c)
            sums[c] += in_row[c];
    }
    return sums;
}

/// The same for any x and y, of the image as it continues outside. The sums are then a bilinear function of the number
/// of whole images, or of copies of the border, in both directions.
Texture::Sums Texture::sums_below(std::int64_t x, std::int64_t y) const
{
    const std::int64_t width = bitmap_.width;
    const std::int64_t height = bitmap_.height;
    if (x >= 0 && x <= width && y >= 0 && y <= height)
        return sums_of_corner(x, y);
    const std::int64_t inside_x = repeats_ ? remainder(x, width) : std::clamp<std::int64_t>(x, 0, width);
    const std::int64_t inside_y = repeats_ ? remainder(y, height) : std::clamp<std::int64_t>(y, 0, height);
    // One period, or the pixel at the border: from the first of these to the second.
    const auto period = [&](std::int64_t at, std::int64_t size) {
        return repeats_ ? std::pair<std::int64_t, std::int64_t>{0, size}
                        : (at < 0 ? std::pair<std::int64_t, std::int64_t>{0, 1} : std::pair{size - 1, size});
    };
    const auto [left, right] = period(x, width);
    const auto [low, high] = period(y, height);
    const std::int64_t periods_x = (x - inside_x) / (right - left);
    const std::int64_t periods_y = (y - inside_y) / (high - low);
    Sums sums{};
    const auto add = [&](std::int64_t factor, std::int64_t at_x, std::int64_t at_y) {
        const Sums corner = factor != 0 ? sums_of_corner(at_x, at_y) : Sums{};
        for (std::size_t c = 0; c < 3; ++c)
            sums[c] += factor * corner[c];
    };
    add(1, inside_x, inside_y);
    add(periods_x, right, inside_y);
    add(-periods_x, left, inside_y);
    add(periods_y, inside_x, high);
    add(-periods_y, inside_x, low);
    add(periods_x * periods_y, right, high);
    add(-periods_x * periods_y, left, high);
    add(-periods_x * periods_y, right, low);
    add(periods_x * periods_y, left, low);
    return sums;
}

/// Linear light of a pixel, which may lie outside the image, in a row of the bitmap.
Texture::Sums Texture::light(std::int64_t x, std::uint32_t row) const
{
    const std::uint8_t* rgb = bitmap_.row(row) + 3 * column(x);
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
        const std::uint32_t in_row = row(y);
        const Sums before = sums_before(x, in_row);
        const Sums start = sums_before(first_column, in_row);
        const Sums under = light(x, in_row);
        for (std::size_t c = 0; c < 3; ++c)
            sums[c] += height * (static_cast<double>(before[c] - start[c]) + within * static_cast<double>(under[c]));
    };
    const auto add_whole_rows = [&](std::int64_t column, double factor) {
        const Sums low = sums_below(column, first);
        const Sums high = sums_below(column, last);
        const Sums low_start = sums_below(first_column, first);
        const Sums high_start = sums_below(first_column, last);
        for (std::size_t c = 0; c < 3; ++c)
            sums[c] += factor * static_cast<double>((high[c] - high_start[c]) - (low[c] - low_start[c]));
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
        const Sums start = sums_before(first_column, in_row);
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] -= start[c];
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
            const Sums passed = ds > 0.0 ? under : light(x - 1, in_row);
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += right * passed[c];
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
