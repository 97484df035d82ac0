// The texture readers on tiny files with known pixels, and on damaged ones.

#include "base/errors.h"
#include "scene/texture/byte_reader.h"
#include "scene/texture/image_formats.h"

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace image_readers_test {

using namespace multipath;

namespace {

using Bytes = std::vector<std::uint8_t>;

/// Bytes from hexadecimal digits; blanks are skipped.
std::string hex(std::string_view digits)
{
    constexpr std::string_view all = "0123456789abcdef";
    std::string bytes;
    bool is_low = false;
    for (const char digit : digits)
        if (const std::size_t value = all.find(digit); value != std::string_view::npos) {
            if (is_low)
                bytes.back() =
                    static_cast<char>((static_cast<unsigned char>(bytes.back()) << 4) | static_cast<int>(value));
            else
                bytes += static_cast<char>(value);
            is_low = !is_low;
        }
    return bytes;
}

/// The pixels in hexadecimal digits, rows separated by " / "; or what the reader complains of.
std::string picture(std::string_view name, const std::string& bytes)
{
    constexpr std::string_view digits = "0123456789abcdef";
    try {
        const Bitmap image = read_image(name, bytes);
        REQUIRE(image.rgb.size() == std::size_t{3} * image.width * image.height);
        std::string text;
        for (std::size_t i = 0; i < image.rgb.size(); ++i) {
            if (i > 0 && i % 3 == 0)
                text += i % (std::size_t{3} * image.width) == 0 ? " / " : " ";
            text += digits[image.rgb[i] >> 4];
            text += digits[image.rgb[i] & 15];
        }
        return text;
    } catch (const ImageError& error) {
        return error.what();
    }
}

std::string big_endian(std::size_t value)
{
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>(value >> shift & 255);
    return bytes;
}

std::string chunk(const std::string& type, const std::string& data)
{
    const std::string wrong_checksum = "????";
    return big_endian(data.size()) + type + data + wrong_checksum;
}

/// A zlib stream of one stored block.
std::string stored(const std::string& data)
{
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const char c : data) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    const auto low = static_cast<char>(data.size() & 255);
    const auto high = static_cast<char>(data.size() >> 8);
    const std::string sizes = {low, high, static_cast<char>(~low), static_cast<char>(~high)};
    return hex("7801 01") + sizes + data + big_endian(std::size_t{b} << 16 | a);
}

/// `kind` is bit depth, colour type, 0, 0 and interlacing in hexadecimal digits.
std::string png_start(std::size_t width, std::size_t height, std::string_view kind)
{
    return hex("89504e470d0a1a0a") + chunk("IHDR", big_endian(width) + big_endian(height) + hex(kind));
}

/// `rows` are the filtered rows in hexadecimal digits.
std::string png(std::size_t width, std::size_t height, std::string_view kind, std::string_view rows,
                const std::string& before = "")
{
    return png_start(width, height, kind) + before + chunk("IDAT", stored(hex(rows))) + chunk("IEND", "");
}

std::string png_picture(std::size_t width, std::size_t height, std::string_view kind, std::string_view rows,
                        const std::string& before = "")
{
    return picture("a.png", png(width, height, kind, rows, before));
}

std::string tga_picture(std::string_view digits)
{
    return picture("a.tga", hex(digits));
}

std::string bmp_picture(std::string_view digits)
{
    return picture("a.bmp", "BM" + hex(digits));
}

std::string pnm_picture(const std::string& bytes)
{
    return picture("a.ppm", bytes);
}

/// A PNG of 12 x 12 colours, compressed by zlib with dynamic codes.
std::string dynamic_png()
{
    return hex("89504e470d0a1a0a0000000d494844520000000c0000000c0802000000d917cbb00000011d4944415478da1d91a1b586210c"
               "43330492836604448740a0aa1900d921aaab910cd01110df188cf2fa3f490e2437010032ca02017c211706f8fa1701cae005"
               "f91d5a22ad9c495eb7373d0b544bdb949ddb271acf1a64543bdd9b00bbe0a396f8908c694d7d384e580ed022be22c32d27cf"
               "1d43cbfd68551e53d6b60b47d068e7b765256bd35b28b53c21fd7891a8da8b4b0a39d3f0b986879741a49b51e5a869f2130c"
               "11179157280787caaab6b61f42f6723b9d8fef941ce01778d185e87eac225aedbab78997caddf43a4733bc70db3426bf88f8"
               "eca8bfc84d054e4f1851f3b71c24bb2d754c5c2a371102794b1643f75ca3598931a945904bdef6c226e69d453b35e25ca525"
               "d368d740037c20edff43c2b9a19c7ff1b733ecc0ff00b95f99db3a988d4e0000000049454e44ae426082");
}

constexpr std::string_view packed_tga = "00 00 0a 0000 0000 00 0000 0000 0500 0200 18 20"
                                        "81 0000ff  03 00ff00 ff0000 00ff00 0000ff  83 ff0000";
constexpr std::string_view plain_bmp = "00000000 0000 0000 42000000 28000000 04000000 03000000 0100 0800"
                                       "00000000 00000000 00000000 00000000 03000000 00000000"
                                       "0000ff00 00ff0000 ff000000  01010100 02010200 00020001";

std::string inflated(const std::string& stream, std::size_t size)
{
    try {
        const std::vector<std::uint8_t> contents = inflate(stream, size);
        return {contents.begin(), contents.end()};
    } catch (const ImageError& error) {
        return error.what();
    }
}

/// 500 copies, each with up to four bytes changed and some cut off, are images or refused.
void check_damaged_copies(std::string_view name, const std::string& bytes)
{
    std::minstd_rand random(1);
    const auto below = [&random](std::size_t limit) { return std::size_t{random()} / 7 % limit; };
    std::size_t refused = 0;
    for (int copy = 0; copy < 500; ++copy) {
        std::string damaged = bytes;
        for (std::size_t changes = below(4) + 1; changes > 0; --changes)
            damaged[below(damaged.size())] = static_cast<char>(below(256));
        if (copy % 4 == 0)
            damaged.resize(below(damaged.size()));
        try {
            const Bitmap image = read_image(name, damaged);
            REQUIRE(image.rgb.size() == std::size_t{3} * image.width * image.height);
        } catch (const ImageError&) {
            ++refused;
        }
    }
    CHECK(refused > 0);
}

} // namespace

TEST_CASE("the first bytes of an image choose its reader, its name only that of TGA")
{
    const std::string pixel = "P6 1 1 255\nabc";
    CHECK(picture("a.tga", pixel) == "616263");
    CHECK(picture("a.jpg", png(1, 1, "08 02 000000", "00 010203")) == "010203");
    const std::string tga = hex("00 00 02 0000 0000 00 0000 0000 0100 0100 18 00 010203");
    CHECK(picture("A.TgA", tga) == "030201");
    const std::string refusal = "is not a PNG, JPEG, TGA, BMP or PPM file";
    CHECK(picture("tga", tga) == refusal);
    CHECK(picture("", "") == refusal);
    CHECK(picture("a.ppm", "P7 1 1 255\nabc") == refusal);
    CHECK(picture("a.ppm", "P61 1 255\nabc") == refusal);
    CHECK(picture("a.pbm", "P1 3 1\n010") == refusal);
    CHECK(picture("a.tga", hex("ffd8")) != refusal);
}

TEST_CASE("a bitmap has one to 2^26 pixels")
{
    const Bitmap black = blank_bitmap(3, 2);
    CHECK(black.rgb == std::vector<std::uint8_t>(18));
    CHECK_THROWS_WITH_AS(blank_bitmap(0, 7), "has no pixels", ImageError);
    CHECK_THROWS_WITH_AS(blank_bitmap(1u << 26, 2),
                         "67108864 x 2 pixels are too many, expected at most 2^26, and 2^16 in a row", ImageError);
    CHECK_THROWS_AS(blank_bitmap(0xffffffffu, 0xffffffffu), ImageError);
    CHECK_THROWS_AS(blank_bitmap((1u << 16) + 1, 1), ImageError);
}

TEST_CASE("inflate unpacks stored blocks and those of fixed and dynamic codes")
{
    CHECK(inflated(stored("hello"), 5) == "hello");
    CHECK(inflated(hex("78014b4c4a4ec48614017c320952"), 25) == "abcabcabcabcabcabcabcabc!");

    std::string squares;
    for (int i = 0; i < 400; ++i)
        squares += static_cast<char>(i * i / 7 % 23);
    CHECK(inflated(
              hex("78dae5ce8111c32008405144880a6294a0fb8fdaf4ae5bf40ff0ee0340c2cca5e95891b89903eb82cb827ab09dba68243db2"
                  "e528589e65f7ec82ae14a362dcc229a64921841d8faf377f620352119baf2877601d41ea289efb2e331bfcc03468d5631c9d"
                  "c22e58cae0d65e710d6d853326f8f64f831fdce2106c"),
              400) == squares);

    // Letters as frequent as Fibonacci numbers have code words of all lengths, here up to 12 bits.
    std::string letters;
    for (int letter = 0, count = 1, before = 0; letter < 12; ++letter) {
        letters.append(static_cast<std::size_t>(count), static_cast<char>('a' + letter));
        before = std::exchange(count, count + before);
    }
    CHECK(inflated(
              hex("780105c14102c3300cc3b0b7ae6d624be4ffcf037ecffb7edf77ce39e7de7befbd7766666666666676777777777777777777"
                  "3749922449922449922449922469dbb66ddbb66ddbb66ddbb66ddbb66ddbb66ddbb600000000000000000000000000000000"
                  "000000000000a8aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaafe0111a29c4d"),
              376) == letters);
}

TEST_CASE("inflate refuses streams that are damaged, cut off or of another size")
{
    const std::string damaged = "has damaged pixel data";
    const std::string cut = "ends too early";
    const std::string stream = hex("78014b4c4a4ec48614017c320952");
    for (std::size_t size = 0; size < stream.size(); ++size)
        CHECK(inflated(stream.substr(0, size), 25) == cut);
    CHECK(inflated(stream, 24) == damaged);
    CHECK(inflated(stream, 26) == cut);
    CHECK(inflated(stream, std::size_t{1} << 30) == cut);
    std::string wrong_sum = stream;
    wrong_sum.back() = 0;
    CHECK(inflated(wrong_sum, 25) == damaged);
    CHECK(inflated(hex("7901 010000ffff00000001"), 0) == damaged);         // header
    CHECK(inflated(hex("7820 010000ffff00000001"), 0) == damaged);         // wants a dictionary
    CHECK(inflated(hex("7801 07 00000000"), 1) == damaged);                // block of the reserved type
    CHECK(inflated(hex("7801 010100ffff61"), 1) == damaged);               // stored size and its complement differ
    CHECK(inflated(hex("7801 03 02 00 00000000"), 3) == damaged);          // match before the first byte
    CHECK(inflated(hex("7801 05 c0ff ffffffffffffffffff"), 9) == damaged); // more code words than there are
}

TEST_CASE("PNG: every colour type and depth")
{
    CHECK(png_picture(9, 2, "01 00 000000", "00 a580 00 0000") ==
          "ffffff 000000 ffffff 000000 000000 ffffff 000000 ffffff ffffff / "
          "000000 000000 000000 000000 000000 000000 000000 000000 000000");
    CHECK(png_picture(5, 1, "02 00 000000", "00 1b40") == "000000 555555 aaaaaa ffffff 555555");
    CHECK(png_picture(3, 1, "04 00 000000", "00 0f10") == "000000 ffffff 111111");
    CHECK(png_picture(2, 1, "08 00 000000", "00 0180") == "010101 808080");
    CHECK(png_picture(2, 1, "10 00 000000", "00 01ff 8000") == "010101 808080");
    CHECK(png_picture(2, 1, "08 02 000000", "00 010203 a0b0c0") == "010203 a0b0c0");
    CHECK(png_picture(1, 1, "10 02 000000", "00 01ff 02ff 0300") == "010203");
    CHECK(png_picture(2, 1, "08 04 000000", "00 0100 80ff") == "010101 808080");
    CHECK(png_picture(1, 1, "10 04 000000", "00 01ff 0000") == "010101");
    CHECK(png_picture(2, 1, "08 06 000000", "00 01020300 a0b0c0ff") == "010203 a0b0c0");
    CHECK(png_picture(1, 1, "10 06 000000", "00 01ff 02ff 0300 0000") == "010203");
}

TEST_CASE("PNG: a palette, black behind its end")
{
    const std::string palette = chunk("PLTE", hex("ff0000 00ff00 0000ff"));
    CHECK(png_picture(3, 1, "01 03 000000", "00 40", palette) == "ff0000 00ff00 ff0000");
    CHECK(png_picture(4, 1, "02 03 000000", "00 1b", palette) == "ff0000 00ff00 0000ff 000000");
    CHECK(png_picture(2, 1, "04 03 000000", "00 2f", palette) == "0000ff 000000");
    CHECK(png_picture(2, 1, "08 03 000000", "00 01ff", palette) == "00ff00 000000");
    CHECK(png_picture(1, 1, "08 03 000000", "00 00") == "has no palette");
    CHECK(png_picture(1, 1, "08 03 000000", "00 00", chunk("PLTE", "abcd")) == "has a damaged palette");
    CHECK(png_picture(1, 1, "08 03 000000", "00 00", chunk("PLTE", std::string(771, 'a'))) == "has a damaged palette");
}

TEST_CASE("PNG: filters predict from the left, above, their mean and the Paeth predictor")
{
    CHECK(png_picture(3, 4, "08 00 000000",
                      "01 102030"     // 10, 10 + 20, 30 + 30
                      "02 00f0d0"     // 10, 30 - 10, 60 - 30
                      "03 080808"     // 10 / 2 + 8, (10 + 20) / 2 + 8, (20 + 30) / 2 + 8
                      "00 ffffff") == // as they are
          "101010 303030 606060 / 101010 202020 303030 / 101010 202020 303030 / ffffff ffffff ffffff");
    CHECK(png_picture(4, 2, "08 00 000000",
                      "00 20303050"
                      "04 f0010203") == // above, 20 - 10; corner, 20 + 1; left, 21 + 2; above, 50 + 3
          "202020 303030 303030 505050 / 101010 212121 232323 535353");
    CHECK(png_picture(1, 1, "08 00 000000", "05 00") == "has damaged pixel data");
}

TEST_CASE("PNG: Adam7 interlacing, also of images that lack some passes")
{
    CHECK(png_picture(1, 1, "08 00 000001", "00 01") == "010101");
    CHECK(png_picture(1, 3, "08 00 000001", "00 01 00 03 00 02") == "010101 / 020202 / 030303");
    CHECK(png_picture(3, 2, "08 00 000001", "00 01 00 03 00 02 00 040506") ==
          "010101 020202 030303 / 040404 050505 060606");
    // Passes of an image of 5 x 5: (0, 0); (4, 0); (0, 4), (4, 4); (2, 0), (2, 4); row 2; odd columns; odd rows.
    CHECK(
        png_picture(5, 5, "08 00 000001",
                    "00 00 00 04 00 4044 00 02 00 42 00 202224 00 0103 00 2123 00 4143 00 1011121314 00 3031323334") ==
        "000000 010101 020202 030303 040404 / 101010 111111 121212 131313 141414 / "
        "202020 212121 222222 232323 242424 / 303030 313131 323232 333333 343434 / "
        "404040 414141 424242 434343 444444");
}

TEST_CASE("PNG: data in several chunks, with others between them that are ignored")
{
    const std::string stream = stored(hex("00 010203"));
    const std::string start =
        png_start(1, 1, "08 02 000000") + chunk("gAMA", hex("00000001")) + chunk("tRNS", "123456");
    const std::string end = chunk("IEND", "");
    const std::string data =
        chunk("IDAT", stream.substr(0, 3)) + chunk("IDAT", "") + chunk("tEXt", "?") + chunk("IDAT", stream.substr(3));
    CHECK(picture("a", start + data + end) == "010203");
    CHECK(picture("a", start + data + chunk("WHAT", "") + end) == "has a chunk of an unknown type");
    CHECK(picture("a", start + data) == "ends too early");
    CHECK(picture("a", start + chunk("IDAT", stream.substr(0, 9)) + end) == "ends too early");
    CHECK(picture("a", start + end) == "ends too early");
    CHECK(picture("a", hex("89504e470d0a1a0a") + data + end) == "does not begin with a header");
}

TEST_CASE("PNG: unknown kinds of pixels and compression are refused")
{
    for (const char* const kind : {"00 00 000000", "03 00 000000", "20 00 000000", "04 02 000000", "10 03 000000",
                                   "08 01 000000", "08 05 000000", "08 07 000000", "04 04 000000", "01 06 000000"})
        CHECK(png_picture(1, 1, kind, "00 00") == "has an unknown pixel format");
    for (const char* const kind : {"08 00 010000", "08 00 000100", "08 00 000002"})
        CHECK(png_picture(1, 1, kind, "00 00") == "uses an unknown compression method");
}

TEST_CASE("PNG: a small file of a huge image is refused by its size")
{
    CHECK(png_picture(16384, 16384, "08 02 000000", "00") ==
          "16384 x 16384 pixels are too many, expected at most 2^26, and 2^16 in a row");
    CHECK(png_picture(8192, 8192, "10 06 000000", "00") == "ends too early");
    CHECK(png_picture(0, 1, "08 02 000000", "00") == "has no pixels");
}

TEST_CASE("PNG, TGA and BMP: opacity, per pixel, of a palette and of a single colour")
{
    const auto opacity = [](const std::string& name, const std::string& bytes) {
        std::string digits;
        for (const std::uint8_t alpha : read_image(name, bytes).alpha)
            digits += std::to_string(alpha) + " ";
        return digits;
    };
    CHECK(opacity("a", png(2, 1, "08 06 000000", "00 01020300 a0b0c0ff")) == "0 255 ");
    CHECK(opacity("a", png(2, 1, "10 06 000000", "00 000000000000 80ff 000000000000 7fff")) == "128 127 ");
    CHECK(opacity("a", png(2, 1, "08 04 000000", "00 0110 80ff")) == "16 255 ");
    CHECK(opacity("a", png(2, 1, "08 02 000000", "00 010203 a0b0c0")) == "");
    const auto transparent = [](const std::string& data) { return chunk("tRNS", hex(data)); };
    const std::string palette = chunk("PLTE", hex("ff0000 00ff00 0000ff")) + transparent("00 80");
    CHECK(opacity("a", png(3, 1, "02 03 000000", "00 18", palette)) == "0 128 255 ");
    CHECK(opacity("a", png(2, 1, "08 02 000000", "00 010203 010204", transparent("0001 0002 0003"))) == "0 255 ");
    CHECK(opacity("a", png(2, 1, "10 00 000000", "00 0102 0103", transparent("0103"))) == "255 0 ");
    CHECK(opacity("a", png(4, 1, "02 00 000000", "00 1b", transparent("0002"))) == "255 255 0 255 ");
    CHECK(opacity("a", png(1, 1, "08 02 000000", "00 010203", transparent("00"))) == "255 ");
    // Adam7: the pixels (0, 0), then (1, 0)
    CHECK(opacity("a", png(2, 1, "08 04 000001", "00 0110 00 0220")) == "16 32 ");
    const auto tga = [](const char* bits, const char* descriptor, const char* pixels) {
        return hex(std::string("00 00 02 0000 0000 00 0000 0000 0200 0100") + bits + descriptor + pixels);
    };
    CHECK(opacity("a.tga", tga("20", "28", "01020380 a0b0c0ff")) == "128 255 ");
    CHECK(opacity("a.tga", tga("20", "20", "01020380 a0b0c0ff")) == ""); // no such bits
    CHECK(opacity("a.tga", tga("20", "28", "01020300 a0b0c000")) == ""); // not used
    // Masks of red, green, blue and, from 56 bytes of header on, of opacity; 2 x 1 pixels.
    const auto bmp = [](const char* offset, const char* header, const char* bits, const char* compression,
                        const std::string& masks_and_pixels) {
        return "BM" + hex(std::string("00000000 0000 0000") + offset + header + "02000000 01000000 0100" + bits +
                          compression + "00000000 00000000 00000000 00000000 00000000" + masks_and_pixels);
    };
    const std::string masks = "0000ff00 00ff0000 ff000000 000000ff";
    CHECK(opacity("a", bmp("46000000", "38000000", "2000", "03000000", masks + "01020380 a0b0c0ff")) == "128 255 ");
    const std::string no_opacity = masks.substr(0, 27) + "00000000";
    CHECK(opacity("a", bmp("46000000", "38000000", "2000", "03000000", no_opacity + "01020380 a0b0c0ff")) == "");
    CHECK(opacity("a", bmp("46000000", "38000000", "2000", "03000000", masks + "01020300 a0b0c000")) == ""); // not used
    CHECK(opacity("a", bmp("42000000", "28000000", "2000", "03000000", masks.substr(0, 26) + "01020380 a0b0c0ff")) ==
          "");
    CHECK(opacity("a", bmp("36000000", "28000000", "2000", "00000000", "01020380 a0b0c0ff")) == "");
}

TEST_CASE("TGA: colours of 24 and 32 bits, and greys; palettes and 16 bits are refused")
{
    const std::string_view rgb_23 = "0000 0000 00 0000 0000 0200 0100";
    const auto rgb = [&](std::string_view bits, std::string_view pixels) {
        return tga_picture("00 00 02" + std::string(rgb_23) + std::string(bits) + "20" + std::string(pixels));
    };
    CHECK(rgb("18", "010203 a0b0c0") == "030201 c0b0a0");
    CHECK(rgb("20", "01020300 a0b0c0ff") == "030201 c0b0a0");
    CHECK(rgb("10", "00fc e083") == "16 bits per pixel are not supported");
    CHECK(rgb("08", "0102") == "8 bits per pixel are not supported");
    CHECK(tga_picture("00 00 03 0000 0000 00 0000 0000 0200 0100 08 20 0180") == "010101 808080");
    CHECK(tga_picture("00 00 03 0000 0000 00 0000 0000 0200 0100 10 20 01ff 8000") == "010101 808080");
    CHECK(tga_picture("00 00 03 0000 0000 00 0000 0000 0200 0100 18 20 010203 040506") ==
          "24 bits per pixel are not supported");
    CHECK(tga_picture("00 01 01 0000 0100 20 0000 0000 0100 0100 08 20 01020304 00") ==
          "is a TGA image of the unsupported type 1");
    // An identification of two bytes, and a palette that is not used.
    CHECK(tga_picture("02 01 02 0000 0100 18 0000 0000 0100 0100 18 20 abcd 010203 040506") == "060504");
}

TEST_CASE("TGA: rows from above and from below")
{
    const auto from = [](std::string_view descriptor) {
        return tga_picture("00 00 03 0000 0000 00 0000 0000 0200 0200 08" + std::string(descriptor) + "01020304");
    };
    CHECK(from("20") == "010101 020202 / 030303 040404");
    CHECK(from("00") == "030303 040404 / 010101 020202");
    for (const char* const descriptor : {"30", "10", "60"})
        CHECK(from(descriptor) == "has interleaved rows, or rows from the right, which are not supported");
}

TEST_CASE("TGA: packets of runs and of single pixels, across rows")
{
    CHECK(tga_picture(packed_tga) == "ff0000 ff0000 00ff00 0000ff 00ff00 / ff0000 0000ff 0000ff 0000ff 0000ff");
    CHECK(tga_picture("00 00 0a 0000 0000 00 0000 0000 0300 0100 18 20 81010203 00040506") == "030201 030201 060504");
    CHECK(tga_picture("00 00 0b 0000 0000 00 0000 0000 0300 0100 08 20 ff07") == "070707 070707 070707");
    CHECK(tga_picture("00 00 0b 0000 0000 00 0000 0000 0300 0100 08 20 8107") == "ends too early");
    CHECK(tga_picture("00 00 0b 0000 0000 00 0000 0000 ffff 0004 08 20 ff07") == "ends too early");
}

TEST_CASE("TGA: other types and files cut short are refused")
{
    CHECK(tga_picture("00 00 20 0000 0000 00 0000 0000 0100 0100 18 20 010203") ==
          "is a TGA image of the unsupported type 32");
    CHECK(tga_picture("00 00 00 0000 0000 00 0000 0000 0100 0100 18 20 010203") ==
          "is a TGA image of the unsupported type 0");
    CHECK(tga_picture("00 00 03 0000 0000 00 0000 0000 0000 0100 08 20") == "has no pixels");
    const std::string_view whole = "00 00 03 0000 0000 00 0000 0000 0200 0100 08 20 0102";
    for (std::size_t size = 0; size < hex(whole).size(); ++size)
        CHECK(picture("a.tga", hex(whole).substr(0, size)) == "ends too early");
}

TEST_CASE("BMP: palettes and rows padded to four bytes")
{
    const std::string info = "00000000 0000 0000 42000000 28000000 03000000 ffffffff 0100";
    const std::string rest = "00000000 00000000 00000000 00000000 03000000 00000000 0000ff00 00ff0000 ff000000";
    CHECK(bmp_picture(info + "0400" + rest + "0120 0000") == "ff0000 00ff00 0000ff");
    CHECK(bmp_picture(info + "0400" + rest + "f120") == "000000 00ff00 0000ff"); // last row without padding
    CHECK(bmp_picture(info + "0800" + rest + "02ff01 00") == "0000ff 000000 00ff00");
    CHECK(bmp_picture(info + "0800" + rest + "02ff") == "ends too early");
}

TEST_CASE("BMP: colours of 32 bits, with and without masks, from above and from below")
{
    const auto info = [](std::string_view offset, std::string_view height, std::string_view bits) {
        return "00000000 0000 0000" + std::string(offset) + "28000000 01000000" + std::string(height) + "0100" +
               std::string(bits);
    };
    const std::string zeros = "00000000 00000000 00000000 00000000 00000000";
    CHECK(bmp_picture(info("36000000", "02000000", "2000") + "00000000" + zeros + "01020300 a0b0c0ff") ==
          "c0b0a0 / 030201");
    CHECK(bmp_picture(info("36000000", "feffffff", "2000") + "00000000" + zeros + "01020300 a0b0c0ff") ==
          "030201 / c0b0a0");
    const std::string masks_rgbx = "000000ff 0000ff00 00ff0000";
    CHECK(bmp_picture(info("42000000", "01000000", "2000") + "03000000" + zeros + masks_rgbx + "01020304") == "040302");
    const std::string masks_10 = "0000f03f 00fc0f00 ff030000"; // 10 bits each
    const std::string no_green = "0000ff00 00000000 ff000000";
    for (const std::string& masks : {masks_10, no_green})
        CHECK(bmp_picture(info("42000000", "01000000", "2000") + "03000000" + zeros + masks + "01020304") ==
              "has colours that are not whole bytes, which is not supported");
}

namespace {

std::string little_endian(std::size_t value, std::size_t bytes)
{
    std::string text;
    for (std::size_t k = 0; k < bytes; ++k)
        text += static_cast<char>(value >> 8 * k & 255);
    return text;
}

/// Two rows of indices, that from below first, in a BMP of these bits with a palette of `colours`.
std::string bmp_file(std::size_t width, std::size_t bits, const Bytes& colours, const std::string& data)
{
    std::string palette;
    for (std::size_t k = 0; k < colours.size(); k += 3)
        for (const std::size_t channel : {2u, 1u, 0u, 3u})
            palette += channel == 3 ? '\0' : static_cast<char>(colours[k + channel]);
    return "BM" + std::string(8, '\0') + little_endian(54 + palette.size(), 4) + little_endian(40, 4) +
           little_endian(width, 4) + little_endian(2, 4) + little_endian(1, 2) + little_endian(bits, 2) +
           std::string(4, '\0') + std::string(12, '\0') + little_endian(colours.size() / 3, 4) + std::string(4, '\0') +
           palette + data;
}

/// Indices of `bits` bits each, one after the other, filled up with zeros to whole words of `word` bytes.
std::string packed_bits(const Bytes& indices, std::size_t bits, std::size_t word)
{
    std::string text((indices.size() * bits + 8 * word - 1) / (8 * word) * word, '\0');
    for (std::size_t k = 0; k < indices.size(); ++k)
        text[k * bits / 8] =
            static_cast<char>(static_cast<unsigned char>(text[k * bits / 8]) | indices[k] << (8 - bits - k * bits % 8));
    return text;
}

} // namespace

TEST_CASE("BMP: rows have their pixels, however many they are")
{
    Bytes colours;
    for (unsigned k = 0; k < 48; ++k)
        colours.push_back(static_cast<std::uint8_t>(k * 91 + 7));
    for (std::size_t width = 4; width < 256; ++width) {
        CAPTURE(width);
        for (const std::size_t bits : {1u, 4u, 8u, 24u}) {
            CAPTURE(bits);
            Bytes pixels;     // from the top
            std::string rows; // from below
            for (const std::size_t row : {0u, 1u}) {
                Bytes indices(width);
                for (std::size_t k = 0; k < width; ++k)
                    indices[k] = static_cast<std::uint8_t>((k * k + 3 * row + k / 7) % (bits == 1 ? 2 : 16));
                Bytes in_colour, in_file;
                for (const std::uint8_t index : indices)
                    for (const std::size_t channel : {0u, 1u, 2u}) {
                        in_colour.push_back(colours[3u * index + channel]);
                        in_file.push_back(colours[3u * index + 2 - channel]);
                    }
                pixels.insert(pixels.begin(), in_colour.begin(), in_colour.end());
                rows += bits == 24 ? packed_bits(in_file, 8, 4) : packed_bits(indices, bits, 4);
            }
            const Bytes used = bits == 24 ? Bytes{} : Bytes(colours.begin(), colours.begin() + (bits == 1 ? 6 : 48));
            CHECK(read_image("a.bmp", bmp_file(width, bits, used, rows)).rgb == pixels);
        }
    }
}

TEST_CASE("BMP: what is unknown, empty or cut short is refused")
{
    const auto info = [](std::string_view size, std::string_view bits_and_compression) {
        return "00000000 0000 0000 36000000 28000000" + std::string(size) + "0100" + std::string(bits_and_compression) +
               "00000000 00000000 00000000 00000000 00000000 01020300";
    };
    const std::string one = "01000000 01000000";
    CHECK(bmp_picture(info(one, "1800 00000000")) == "030201");
    CHECK(bmp_picture(info(one, "0200 00000000")) == "2 bits per pixel are not supported");
    CHECK(bmp_picture(info(one, "1000 00000000")) == "16 bits per pixel are not supported");
    for (const char* const kind : {"1800 01000000", "0800 01000000", "0400 02000000", "2000 06000000"})
        CHECK(bmp_picture(info(one, kind)) == "uses a compression method that is not supported");
    CHECK(bmp_picture(info(one, "1800 03000000") + "0000000000000000") ==
          "uses a compression method that is not supported");
    for (const char* const size : {"00000000 01000000", "ffffffff 01000000", "01000000 00000000"})
        CHECK(bmp_picture(info(size, "1800 00000000")) == "has no pixels");
    for (const char* const size : {"02000000 01000000", "ffffff7f 00000080", "00400000 00400000"})
        CHECK(bmp_picture(info(size, "1800 00000000")) == "ends too early");
    CHECK(bmp_picture("00000000 0000 0000 36000000 10000000" + one) == "has an unknown kind of header");
    CHECK(bmp_picture("00000000 0000 0000 1a000000 0c000000 0100 0100 0100 1800 010203 00") ==
          "has an unknown kind of header");
    const std::string whole = "BM" + hex(info(one, "1800 00000000"));
    for (std::size_t size = 2; size + 1 < whole.size(); ++size)
        CHECK(picture("a", whole.substr(0, size)) == "ends too early");
}

TEST_CASE("Netpbm: grey maps and colour maps, as text and binary")
{
    CHECK(pnm_picture("P2 2 1 # 10 levels\n9 0 9") == "000000 ffffff");
    CHECK(pnm_picture("P3\t1\r\n2 255 1 2 3\n160 # red\n176 192") == "010203 / a0b0c0");
    CHECK(pnm_picture("P5 3 1 255#\n" + hex("018020")) == "010101 808080 202020");
    CHECK(pnm_picture("P6 1 1 65535\n" + hex("8000 00ff ff00")) == "8001fe");
    CHECK(pnm_picture("P5 2 1 256 " + hex("0080 0100")) == "808080 ffffff");
    CHECK(pnm_picture("P5 2 1 3 " + hex("0104")) == "555555 ffffff"); // more than the largest
}

TEST_CASE("Netpbm: damaged headers and files cut short are refused")
{
    CHECK(pnm_picture("P5 x") == "has other text where a number is expected");
    CHECK(pnm_picture("P5 1 -1 255 a") == "has other text where a number is expected");
    CHECK(pnm_picture("P5 1 99999999999 255 a") == "has a number that is too large");
    CHECK(pnm_picture("P5 1 1 0 a") == "has a largest value of 0, expected 1 to 65535");
    CHECK(pnm_picture("P5 1 1 65536 a") == "has a largest value of 65536, expected 1 to 65535");
    CHECK(pnm_picture("P5 0 1 255 ") == "has no pixels");
    CHECK(pnm_picture("P2 0 1 255 ") == "has no pixels");
    CHECK(pnm_picture("P6 100000000 100000000 255 ") == "ends too early");
    CHECK(pnm_picture("P5 # no end") == "ends too early");
    for (const std::string whole :
         {"P2 2 1 9 1 2", "P3 1 1 9 1 2 3", "P5 2 1 255 aa", "P5 1 1 300 aa", "P6 1 1 255 aaa"}) {
        CHECK(pnm_picture(whole) != "ends too early");
        for (std::size_t size = 3; size < whole.size(); ++size)
            CHECK(pnm_picture(whole.substr(0, size)) == "ends too early");
    }
}

TEST_CASE("damaged images are read or refused")
{
    check_damaged_copies("a.png", dynamic_png());
    check_damaged_copies("a.png", png(5, 5, "08 00 000001", std::string(2 * (13 + 25), '1')));
    check_damaged_copies("a.tga", hex(packed_tga));
    check_damaged_copies("a.bmp", "BM" + hex(plain_bmp));
    check_damaged_copies("a.ppm", "P3 2 2 9\n1 2 3 4 5 6 7 8 9 1 2 3");
    check_damaged_copies("a.ppm", "P6 2 2 255\nabcdefghijkl");
}

} // namespace image_readers_test
