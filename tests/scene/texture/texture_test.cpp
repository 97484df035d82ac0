#include "scene/texture/texture.h"

#include "sampling/halton.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <string>

namespace texture_test {

using namespace multipath;

namespace {

/// Of any size, each pixel in a colour of its own.
std::string motley(int width, int height)
{
    std::string text = "P3 " + std::to_string(width) + " " + std::to_string(height) + " 255\n";
    for (int k = 0; k < width * height; ++k)
        text += std::to_string((k * 37 + 11) % 256) + " " + std::to_string((k * k * 53) % 256) + " " +
                std::to_string(255 - (k * 91) % 256) + "\n";
    return text;
}

Texture texture(int width, int height, bool repeats = true)
{
    return Texture("a.ppm", motley(width, height), repeats);
}

/// The texture as it is defined, pixel by pixel.
Rgb pixel_at(const Texture& t, TexturePoint p)
{
    const double w = t.bitmap().width;
    const double h = t.bitmap().height;
    const auto place = [&](double x, double n) {
        const double k = std::floor(x * n);
        return t.repeats() ? k - n * std::floor(k / n) : std::min(std::max(k, 0.0), n - 1.0);
    };
    const auto x = static_cast<std::uint32_t>(place(p.s, w));
    const auto y = static_cast<std::uint32_t>(h - 1.0 - place(p.t, h));
    return linear_colour(t.bitmap().row(y) + 3 * x);
}

Rgb sampled_mean(const Texture& t, const TexturePolygon& f)
{
    Rgb sum;
    constexpr int samples = 40000;
    for (int k = 1; k <= samples; ++k) {
        double a = radical_inverse(2, static_cast<std::uint64_t>(k));
        double b = radical_inverse(3, static_cast<std::uint64_t>(k));
        if (f.size() == 3 && a + b > 1.0) {
            a = 1.0 - a;
            b = 1.0 - b;
        }
        const TexturePoint o = f[0];
        const TexturePoint u = f[1];
        const TexturePoint v = f.back();
        sum += pixel_at(t, {o.s + a * (u.s - o.s) + b * (v.s - o.s), o.t + a * (u.t - o.t) + b * (v.t - o.t)});
    }
    return 1.0 / samples * sum;
}

TexturePolygon parallelogram(TexturePoint o, TexturePoint u, TexturePoint v)
{
    return {o, {o.s + u.s, o.t + u.t}, {o.s + u.s + v.s, o.t + u.t + v.t}, {o.s + v.s, o.t + v.t}};
}

bool is_near(Rgb a, Rgb b, double tolerance)
{
    return std::abs(a.r - b.r) < tolerance && std::abs(a.g - b.g) < tolerance && std::abs(a.b - b.b) < tolerance;
}

} // namespace

TEST_CASE("the mean over a polygon is that of its points, wherever it lies on a repeated or clamped texture")
{
    for (const bool repeats : {true, false})
        for (const auto& size : {std::pair{5, 3}, {17, 40}, {64, 1}, {1, 7}}) {
            const Texture t = texture(size.first, size.second, repeats);
            for (const TexturePolygon& f :
                 {parallelogram({0.1, 0.2}, {0.7, 0.1}, {-0.2, 0.5}),
                  parallelogram({-3.3, 7.9}, {5.1, 0.4}, {0.3, -2.2}),
                  parallelogram({0.31, 0.77}, {0.001, 0.0}, {0.0, 0.002}), parallelogram({0, 0}, {0, 1}, {1, 0}),
                  TexturePolygon{{0.9, 0.1}, {1.4, 0.3}, {0.2, 1.8}},
                  TexturePolygon{{-0.5, -0.5}, {-0.7, -0.5}, {-0.5, -0.9}}}) {
                CAPTURE(size.first);
                CAPTURE(f[0].s);
                CHECK(is_near(t.mean(f), sampled_mean(t, f), 4e-3));
            }
        }
}

// The part of a polygon on one side of a line (Sutherland and Hodgman 1974): where sign * (s or t) <= sign * limit.
TexturePolygon clipped(const TexturePolygon& p, double TexturePoint::*axis, double limit, double sign)
{
    TexturePolygon inside;
    for (std::size_t k = 0; k < p.size(); ++k) {
        const TexturePoint a = p[k];
        const TexturePoint b = p[(k + 1) % p.size()];
        const double at_a = sign * (a.*axis - limit);
        const double at_b = sign * (b.*axis - limit);
        if (at_a <= 0.0)
            inside.push_back(a);
        if (at_a * at_b < 0.0) {
            const double x = at_a / (at_a - at_b);
            inside.push_back({a.s + x * (b.s - a.s), a.t + x * (b.t - a.t)});
        }
    }
    return inside;
}

/// The mean by areas of the polygon in every pixel.
Rgb mean_by_pixels(const Texture& t, const TexturePolygon& p)
{
    const double w = t.bitmap().width;
    const double h = t.bitmap().height;
    Rgb sum;
    double area = 0.0;
    double low_s = p[0].s, high_s = p[0].s, low_t = p[0].t, high_t = p[0].t;
    for (const TexturePoint q : p) {
        low_s = std::min(low_s, q.s);
        high_s = std::max(high_s, q.s);
        low_t = std::min(low_t, q.t);
        high_t = std::max(high_t, q.t);
    }
    for (double y = std::floor(low_t * h); y < high_t * h; y += 1.0) {
        TexturePolygon in_row = clipped(p, &TexturePoint::t, y / h, -1.0);
        in_row = clipped(in_row, &TexturePoint::t, (y + 1.0) / h, 1.0);
        for (double x = std::floor(low_s * w); x < high_s * w; x += 1.0) {
            TexturePolygon in_pixel = clipped(in_row, &TexturePoint::s, x / w, -1.0);
            in_pixel = clipped(in_pixel, &TexturePoint::s, (x + 1.0) / w, 1.0);
            const double part = std::abs(area_of(in_pixel));
            sum += part * pixel_at(t, {(x + 0.5) / w, (y + 0.5) / h});
            area += part;
        }
    }
    return 1.0 / area * sum;
}

TEST_CASE("the mean over a polygon is that of its parts in the pixels")
{
    std::uint64_t k = 0;
    const auto number = [&] { return radical_inverse(2, ++k * 7919); };
    for (const bool repeats : {true, false})
        for (const auto& size : {std::pair{37, 90}, {5, 3}, {64, 64}, {1, 50}, {33, 8}})
            for (const bool upright : {true, false})
                for (int trial = 0; trial < 12; ++trial) {
                    const Texture t = texture(size.first, size.second, repeats);
                    const TexturePoint o = {3.0 * number() - 1.0, 3.0 * number() - 1.0};
                    const double extent = trial % 3 == 0 ? 0.1 : 1.7;
                    const TexturePoint u = {extent * (number() + 0.01), upright ? 0.0 : extent * (number() - 0.5)};
                    const TexturePoint v = {upright ? 0.0 : extent * (number() - 0.5), extent * (number() + 0.01)};
                    TexturePolygon p = parallelogram(o, u, v);
                    if (trial % 4 == 1)
                        p.pop_back(); // a triangle
                    if (trial % 4 == 2)
                        std::reverse(p.begin(), p.end());
                    CAPTURE(size.first);
                    CAPTURE(upright);
                    CAPTURE(trial);
                    CHECK(is_near(t.mean(p), mean_by_pixels(t, p), 1e-11));
                }
}

TEST_CASE("means of whole pixels and whole textures are exact")
{
    const Texture t = texture(8, 4);
    CHECK(is_near(t.mean(parallelogram({0, 0}, {1, 0}, {0, 1})), t.mean(), 1e-15));
    CHECK(is_near(t.mean(parallelogram({-7, 3}, {0, -4}, {5, 0})), t.mean(), 1e-15));
    CHECK(is_near(t.mean(parallelogram({1e5 + 0.125, 0.25}, {0.125, 0}, {0, 0.25})), pixel_at(t, {0.2, 0.3}), 1e-12));
    // The parts of a quadtree have the mean of the whole.
    const TexturePolygon whole = parallelogram({0.3, 0.1}, {2.7, 0.4}, {0.1, 1.9});
    Rgb sum;
    for (const double a : {0.0, 0.5})
        for (const double b : {0.0, 0.5})
            sum += 0.25 *
                   t.mean(parallelogram({0.3 + a * 2.7 + b * 0.1, 0.1 + a * 0.4 + b * 1.9}, {1.35, 0.2}, {0.05, 0.95}));
    CHECK(is_near(sum, t.mean(whole), 1e-13));
}

TEST_CASE("without an area a footprint shows its middle, and an endless one the mean")
{
    const Texture t = texture(8, 4);
    CHECK(is_near(t.mean(parallelogram({0.3, 0.6}, {0, 0}, {0, 0})), pixel_at(t, {0.3, 0.6}), 1e-15));
    CHECK(is_near(t.mean(parallelogram({0.3, 0.6}, {1e6, 0}, {0, 1e6})), t.mean(), 1e-15));
}

TEST_CASE("between the middles of pixels the colour is linear")
{
    const Texture t("a.ppm", "P3 2 2 255\n0 0 0 255 255 255\n255 0 0 0 0 255\n", true);
    CHECK(is_near(t.at({0.25, 0.25}), {1, 0, 0}, 1e-12)); // the lower left one is that of the last row
    CHECK(is_near(t.at({0.75, 0.75}), {1, 1, 1}, 1e-12));
    CHECK(is_near(t.at({0.5, 0.25}), {0.5, 0, 0.5}, 1e-12));
    CHECK(is_near(t.at({0.0, 0.25}), {0.5, 0, 0.5}, 1e-12)); // across the border
    const Texture clamped("a.ppm", "P3 2 1 255\n0 0 0 255 255 255\n", false);
    CHECK(is_near(clamped.at({-3.0, 0.5}), {0, 0, 0}, 1e-12));
    CHECK(t.hash() != Texture("a.ppm", t.bytes(), false).hash());
}

// Where the image does not repeat, the pixels at its border continue.
TEST_CASE("the colour at a point is bilinear between the middles of the four pixels around it")
{
    std::uint64_t k = 0;
    const auto number = [&] { return 4.0 * radical_inverse(3, ++k * 7919) - 1.5; };
    for (const bool repeats : {true, false})
        for (const auto& size : {std::pair{5, 3}, {2, 7}, {1, 4}, {6, 1}}) {
            const Texture t = texture(size.first, size.second, repeats);
            CAPTURE(size.first);
            for (int trial = 0; trial < 50; ++trial) {
                const TexturePoint p = {number(), number()};
                const double x = std::floor(p.s * size.first - 0.5);
                const double y = std::floor(p.t * size.second - 0.5);
                Rgb expected;
                for (const double right : {0.0, 1.0})
                    for (const double up : {0.0, 1.0})
                        expected += (1.0 - std::abs(p.s * size.first - 0.5 - x - right)) *
                                    (1.0 - std::abs(p.t * size.second - 0.5 - y - up)) *
                                    pixel_at(t, {(x + right + 0.5) / size.first, (y + up + 0.5) / size.second});
                CHECK(is_near(t.at(p), expected, 1e-12));
            }
        }
}

} // namespace texture_test
