#include "image/png.h"

#include "image/checksum.h"
#include "image/inflate.h"
#include "sampling/random.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <map>

namespace png_test {

using namespace multipath;

namespace {

std::size_t number_at(const std::string& bytes, std::size_t i)
{
    std::size_t value = 0;
    for (std::size_t k = i; k < i + 4; ++k)
        value = 256 * value + static_cast<unsigned char>(bytes.at(k));
    return value;
}

/// The chunks' data by type; checks lengths and check sums on the way.
std::map<std::string, std::string> chunks(const std::string& png)
{
    std::map<std::string, std::string> result;
    REQUIRE(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
    for (std::size_t i = 8; i < png.size();) {
        const std::size_t size = number_at(png, i);
        const std::string type_and_data = png.substr(i + 4, size + 4);
        CHECK(number_at(png, i + 8 + size) == crc32(type_and_data));
        result[type_and_data.substr(0, 4)] = type_and_data.substr(4);
        i += 12 + size;
    }
    return result;
}

/// The pixels of filtered rows, after the definitions of the PNG standard, section 9.
std::vector<std::uint8_t> unfiltered(const std::string& data, std::size_t width, std::size_t height)
{
    const std::size_t row = 3 * width;
    std::vector<std::uint8_t> pixels(row * height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < row; ++x) {
            const int a = x >= 3 ? pixels[y * row + x - 3] : 0;
            const int b = y > 0 ? pixels[(y - 1) * row + x] : 0;
            const int c = x >= 3 && y > 0 ? pixels[(y - 1) * row + x - 3] : 0;
            const int p = a + b - c;
            const int nearest = std::abs(p - a) <= std::abs(p - b) && std::abs(p - a) <= std::abs(p - c) ? a
                                : std::abs(p - b) <= std::abs(p - c)                                     ? b
                                                                                                         : c;
            const int predictions[5] = {0, a, b, (a + b) / 2, nearest};
            const int filter = data[y * (row + 1)];
            REQUIRE(filter >= 0);
            REQUIRE(filter <= 4);
            pixels[y * row + x] = static_cast<std::uint8_t>(predictions[filter] +
                                                            static_cast<unsigned char>(data[y * (row + 1) + 1 + x]));
        }
    return pixels;
}

/// Ramps, flat parts and noise, so that each filter is the best somewhere.
ScreenImage varied_picture(int width, int height)
{
    ScreenImage image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                const int ramp = y % 10 < 3 ? 5 * x : y % 10 < 6 ? 7 * y : y % 10 < 8 ? 3 * x + 4 * y : 0;
                const int noise = y % 10 == 9 ? static_cast<int>(random_bits(5, image.bytes.size()) % 256) : 0;
                image.bytes.push_back(static_cast<std::uint8_t>(ramp + 40 * channel + noise));
            }
    return image;
}

/// The pixels that a reader finds in a PNG of them.
std::vector<std::uint8_t> decoded(const ScreenImage& image)
{
    const std::string stream = chunks(png_bytes(image)).at("IDAT");
    return unfiltered(inflate(stream.substr(2, stream.size() - 6)), static_cast<std::size_t>(image.width),
                      static_cast<std::size_t>(image.height));
}

} // namespace

TEST_CASE("the pixels that a PNG reader decodes are those of the picture")
{
    for (const int width : {1, 2, 67}) {
        const ScreenImage image = varied_picture(width, 40);
        const std::map<std::string, std::string> parts = chunks(png_bytes(image));
        const std::string& header = parts.at("IHDR");
        CHECK(number_at(header, 0) == static_cast<std::size_t>(width));
        CHECK(number_at(header, 4) == 40);
        CHECK(header.substr(8) == std::string("\x08\x02\x00\x00\x00", 5));
        CHECK(decoded(image) == image.bytes);
        CHECK(parts.count("tEXt") == 0);
    }
}

// Steps of up to two between columns and between rows: Paeth's predictor, by far the best here, often finds two
// neighbours equally near.
TEST_CASE("a PNG reader agrees where predictions tie")
{
    const auto steps = [](std::uint64_t key) {
        std::vector<int> heights = {64};
        for (std::uint64_t n = 1; n < 64; ++n)
            heights.push_back(heights.back() + static_cast<int>(random_bits(key, n) % 5) - 2);
        return heights;
    };
    const std::vector<int> along = steps(1);
    const std::vector<int> down = steps(2);
    ScreenImage image{64, 64, {}};
    for (std::size_t y = 0; y < 64; ++y)
        for (std::size_t x = 0; x < 64; ++x)
            image.bytes.insert(image.bytes.end(), 3, static_cast<std::uint8_t>(along[x] + down[y]));
    CHECK(decoded(image) == image.bytes);
}

TEST_CASE("the provenance stands in a text chunk")
{
    const std::map<std::string, std::string> parts = chunks(png_bytes(varied_picture(3, 3), "seed 1\nscene cafe"));
    CHECK(parts.at("tEXt") == std::string("Comment\0seed 1\nscene cafe", 25));
}

// One step per column and row: the differences from above are all 1, one long run for the compressor.
TEST_CASE("filters make a smooth ramp nearly free")
{
    ScreenImage image{256, 256, {}};
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            image.bytes.insert(image.bytes.end(), 3, static_cast<std::uint8_t>(x + y));
    CHECK(png_bytes(image).size() < image.bytes.size() / 200);
}

} // namespace png_test
