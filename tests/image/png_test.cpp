#include "image/png.h"

#include "base/checksum.h"
#include "sampling/random.h"

#include <doctest/doctest.h>

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

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

/// A plain reader of deflate streams of one block with the fixed code (RFC 1951, sections 3.2.5 and 3.2.6).
class Inflater
{
public:
    /// Throws std::runtime_error for anything that is not a well-formed stream to its last byte.
    explicit Inflater(const std::string& bytes) : bytes_(bytes)
    {
        if (bits(3) != 3)
            throw std::runtime_error("not one block with the fixed code");
        read_block();
        if ((position_ + 7) / 8 != bytes_.size())
            throw std::runtime_error("bytes left over");
    }

    struct Copy
    {
        unsigned length;
        unsigned distance;
    };

    std::string original;
    std::vector<Copy> copies;

private:
    unsigned bit()
    {
        if (position_ / 8 >= bytes_.size())
            throw std::runtime_error("cut off");
        const auto byte = static_cast<unsigned char>(bytes_[position_ / 8]);
        return byte >> position_++ % 8 & 1u;
    }
    /// A number, its lowest bit first.
    unsigned bits(int count)
    {
        unsigned value = 0;
        for (int i = 0; i < count; ++i)
            value |= bit() << i;
        return value;
    }
    /// A code word, its highest bit first, after those read before.
    unsigned word(int count, unsigned before = 0)
    {
        for (int i = 0; i < count; ++i)
            before = before << 1 | bit();
        return before;
    }
    unsigned symbol()
    {
        const unsigned seven = word(7);
        if (seven <= 0b0010111)
            return 256 + seven;
        const unsigned eight = word(1, seven);
        if (eight <= 0b10111111)
            return eight - 0b00110000;
        if (eight <= 0b11000111)
            return 280 + eight - 0b11000000;
        return 144 + word(1, eight) - 0b110010000;
    }
    void read_block()
    {
        const unsigned length_base[29] = {3,  4,  5,  6,  7,  8,  9,  10, 11,  13,  15,  17,  19,  23, 27,
                                          31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258};
        const int length_extra[29] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                      2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
        const unsigned distance_base[30] = {1,    2,    3,    4,    5,    7,    9,    13,    17,    25,
                                            33,   49,   65,   97,   129,  193,  257,  385,   513,   769,
                                            1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
        for (unsigned s = symbol(); s != 256; s = symbol()) {
            if (s < 256) {
                original += static_cast<char>(s);
                continue;
            }
            if (s > 285)
                throw std::runtime_error("no such length");
            const unsigned length = length_base[s - 257] + bits(length_extra[s - 257]);
            const unsigned d = word(5);
            if (d > 29)
                throw std::runtime_error("no such distance");
            const unsigned distance = distance_base[d] + bits(d < 4 ? 0 : static_cast<int>(d) / 2 - 1);
            if (distance > original.size())
                throw std::runtime_error("copy from before the start");
            for (unsigned i = 0; i < length; ++i)
                original += original[original.size() - distance];
            copies.push_back({length, distance});
        }
    }

    const std::string& bytes_;
    std::size_t position_ = 0; // in bits
};

/// The deflate stream in a PNG of the picture.
std::string deflate_stream(const ScreenImage& image)
{
    const std::string zlib = chunks(png_bytes(image)).at("IDAT");
    return zlib.substr(2, zlib.size() - 6);
}

/// A picture of one row whose differences from the left are the given bytes, three per pixel.
ScreenImage row_of_differences(const std::string& differences)
{
    ScreenImage image{static_cast<int>(differences.size() / 3), 1, {}};
    for (std::size_t i = 0; i < differences.size(); ++i)
        image.bytes.push_back(
            static_cast<std::uint8_t>((i < 3 ? 0 : image.bytes[i - 3]) + static_cast<unsigned char>(differences[i])));
    return image;
}

std::string noise(std::size_t size, std::uint64_t letters)
{
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i)
        bytes += static_cast<char>(random_bits(3, i) % letters);
    return bytes;
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
            const int filter = data[y * (row + 1)];
            REQUIRE(filter >= 1);
            REQUIRE(filter <= 2);
            pixels[y * row + x] = static_cast<std::uint8_t>((filter == 1 ? a : b) +
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
    const std::string stream = deflate_stream(image);
    return unfiltered(Inflater(stream).original, static_cast<std::size_t>(image.width),
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

// 1 is the number of the filter that stores differences from the left.
TEST_CASE("an independent inflate gives back the bytes that were compressed")
{
    for (const std::size_t size : {3u, 6u, 300u, 32766u, 32769u, 99999u})
        for (const std::uint64_t letters : {1u, 2u, 20u, 256u}) {
            const std::string bytes = noise(size, letters);
            const std::string stream = deflate_stream(row_of_differences(bytes));
            CHECK(Inflater(stream).original == "\1" + bytes);
        }
}

TEST_CASE("every length of copy and every distance code survives")
{
    std::string bytes = noise(40000, 256);
    for (std::size_t length = 3; length <= 259; ++length)
        bytes += bytes.substr(bytes.size() - 1 - (length * length) % 32768, length) + static_cast<char>(length);
    bytes.resize(bytes.size() / 3 * 3);
    const std::string stream = deflate_stream(row_of_differences(bytes));
    CHECK(Inflater(stream).original == "\1" + bytes);
}

// The fixed code has 8 bits for 144 literals and 9 for the other 112.
TEST_CASE("independent bytes cost their code words")
{
    const std::string stream = deflate_stream(row_of_differences(noise(99999, 256)));
    CHECK(static_cast<double>(stream.size()) ==
          doctest::Approx(99999.0 * (8 * 144 + 9 * 112) / 256 / 8).epsilon(0.005));
}

// The literal is the number of the filter, 1.
TEST_CASE("a run of equal bytes is one literal and copies of the greatest length")
{
    const std::string stream = deflate_stream(row_of_differences(std::string(5 * 258, '\1')));
    const Inflater inflater(stream);
    REQUIRE(inflater.copies.size() == 5);
    for (const Inflater::Copy& copy : inflater.copies) {
        CHECK(copy.length == 258);
        CHECK(copy.distance == 1);
    }
    CHECK(stream.size() == (3 + 8 + 5 * (8 + 5) + 7 + 7) / 8); // block header, literal, copies, end; rounded up
}

// The window of deflate is 32768 bytes: a repetition at that distance is found, one byte farther it must not be.
TEST_CASE("copies reach back to the edge of the window and not beyond")
{
    const std::string word = "a phrase that noise does not contain";
    for (const std::size_t distance : {std::size_t{32768}, std::size_t{32769}}) {
        std::string bytes = word + noise(distance - word.size(), 256) + word;
        bytes.insert(0, (3 - bytes.size() % 3) % 3, '.');
        const std::string stream = deflate_stream(row_of_differences(bytes));
        const Inflater inflater(stream);
        CHECK(inflater.original == "\1" + bytes);
        REQUIRE_FALSE(inflater.copies.empty());
        CHECK((inflater.copies.back().length == word.size()) == (distance == 32768));
    }
}

// "abc" then "bcdef": at the second "abc" three bytes match, one place later five do.
TEST_CASE("a copy waits when the next position offers a longer one")
{
    const std::string stream = deflate_stream(row_of_differences("abc.bcdef.abcdef--"));
    const Inflater inflater(stream);
    REQUIRE(inflater.copies.size() == 1);
    CHECK(inflater.copies[0].length == 5);
    CHECK(inflater.copies[0].distance == 7);
}

TEST_CASE("a zlib stream has a valid header and ends with the Adler-32 of its content")
{
    const std::string stream = chunks(png_bytes(row_of_differences("the room is bright"))).at("IDAT");
    const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(stream[i])); };
    CHECK(byte(0) % 16 == 8);                   // deflate
    CHECK((256 * byte(0) + byte(1)) % 31 == 0); // check bits of RFC 1950
    CHECK(number_at(stream, stream.size() - 4) == adler32("\1the room is bright"));
}

TEST_CASE("the provenance stands in a text chunk")
{
    const std::map<std::string, std::string> parts = chunks(png_bytes(varied_picture(3, 3), "seed 1\nscene cafe"));
    CHECK(parts.at("tEXt") == std::string("Comment\0seed 1\nscene cafe", 25));
}

TEST_CASE("a row equal to the one above is nearly free")
{
    ScreenImage image{256, 256, {}};
    for (std::size_t i = 0; i < std::size_t{3} * 256 * 256; ++i)
        image.bytes.push_back(static_cast<std::uint8_t>(random_bits(5, i % (3 * 256))));
    CHECK(decoded(image) == image.bytes);
    CHECK(png_bytes(image).size() < 3 * 256 + image.bytes.size() / 100);
}

// One step per column and row: after its first pixel a row of differences is one run, which takes three copies.
TEST_CASE("filters make a smooth ramp nearly free")
{
    ScreenImage image{256, 256, {}};
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            image.bytes.insert(image.bytes.end(), 3, static_cast<std::uint8_t>(x + y));
    CHECK(png_bytes(image).size() < image.bytes.size() / 50);
}

} // namespace png_test
