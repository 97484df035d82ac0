#include "image/bitmap_font.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

namespace bitmap_font_test {

using namespace multipath;

namespace {

const std::string characters = "abcdefghijklmnopqrstuvwxyzW0123456789.+-/[]\xB2";

ScreenImage black(int width, int height)
{
    return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), 0)};
}

std::uint8_t red(const ScreenImage& picture, int x, int y)
{
    return picture.bytes[static_cast<std::size_t>(3 * (y * picture.width + x))];
}

} // namespace

TEST_CASE("no two characters look alike, and none is blank")
{
    std::set<std::vector<std::uint8_t>> looks = {black(5, font_height).bytes};
    for (const char character : characters) {
        ScreenImage picture = black(5, font_height);
        draw_text(picture, 0, 0, 1, std::string(1, character), 255);
        INFO("character ", character);
        CHECK(looks.insert(picture.bytes).second);
    }
}

TEST_CASE("a text lies within its width and height, and neighbours do not touch")
{
    const int width = text_width(characters);
    ScreenImage picture = black(width + 4, font_height + 4);
    draw_text(picture, 2, 2, 1, characters, 255);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const bool inside = x >= 2 && x < 2 + width && y >= 2 && y < 2 + font_height;
            const bool gap = (x - 2) % 6 == 5;
            if (!inside || gap)
                CHECK(red(picture, x, y) == 0);
        }
}

TEST_CASE("a larger scale repeats every pixel")
{
    ScreenImage plain = black(60, 12);
    ScreenImage large = black(180, 36);
    draw_text(plain, 4, 1, 1, "0.25 W/m\xB2", 200);
    draw_text(large, 12, 3, 3, "0.25 W/m\xB2", 200);
    CHECK(std::count(plain.bytes.begin(), plain.bytes.end(), 200) > 0);
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x)
            CHECK(red(large, x, y) == red(plain, x / 3, y / 3));
}

// The oracle is the middle of a picture that has room for all of it.
TEST_CASE("what does not fit into the picture is cut off")
{
    ScreenImage small = black(10, 8);
    ScreenImage roomy = black(90, 48);
    draw_text(small, -7, -3, 2, "show", 255);
    draw_text(roomy, 33, 17, 2, "show", 255);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x)
            CHECK(red(small, x, y) == red(roomy, x + 40, y + 20));
}

} // namespace bitmap_font_test
