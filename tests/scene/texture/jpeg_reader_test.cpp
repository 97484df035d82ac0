// Small files made by cjpeg, jpegtran and ImageMagick; the pixels expected are those of libjpeg-turbo's
// "djpeg -dct int", the accurate integer transform. Rounding may differ by one level.

#include "base/errors.h"
#include "scene/texture/image_formats.h"

#include "image/png.h"
#include "scene/scene_builder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace jpeg_reader_test {

using namespace multipath;

namespace {

std::string from_hex(const std::string& digits)
{
    std::string bytes;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
        bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
    return bytes;
}

/// 8 x 8, one component.
const std::string grey_file = from_hex(
    "ffd8ffe000104a46494600010100000100010000ffdb004300100b0c0e0c0a100e0d0e1211101318281a181616183123251d283a333d3c"
    "3933383740485c4e404457453738506d51575f626768673e4d71797064785c656763ffc0000b080008000801011100ffc4001400010000"
    "0000000000000000000000000003ffc40017100003010000000000000000000000000000030633ffda0008010100003f0018d5667fffd9");

const std::string grey_pixels = from_hex(
    "011b3f5d7695b8d2021d405f7896bad4051f43617b99bdd7092347657f9dc1db0d274b6983a1c5df112b4f6d87a5c9e3142e527089a8cb"
    "e6163053728ba9cde7");

/// 17 x 13, chroma of half resolution in both directions.
const std::string baseline_file = from_hex(
    "ffd8ffe000104a46494600010100000100010000ffdb0043000d090a0b0a080d0b0a0b0e0e0d0f13201513121213271c1e17202e293130"
    "2e292d2c333a4a3e333646372c2d405741464c4e525352323e5a615a50604a51524fffdb0043010e0e0e131113261515264f352d354f4f"
    "4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4fffc0001108000d"
    "001103012200021101031101ffc40017000003010000000000000000000000000000040503ffc400251000000503030403000000000000"
    "000000000102051103041206132114415191525371ffc400160101010100000000000000000000000000030204ffc40024110002010203"
    "09000000000000000000000102030011041214162231415254627192ffda000c03010002110311003f00d2fb52a28ed525a729e0ca203b"
    "78eadf56c69c9248cf9c7f02f77a7ed09db2393ed1024bc33525382169a8a491738c780890e1d8ac4148b6f65bf0f2cdcfd513e96612c8"
    "8482c428aa9bad9f5a7d8023d2a3e4af6015aa5eecfc568d9a8ba8d7ffd9");

/// The same coefficients in the progressive mode.
const std::string progressive_file = from_hex(
    "ffd8ffe000104a46494600010100000100010000ffdb0043000d090a0b0a080d0b0a0b0e0e0d0f13201513121213271c1e17202e293130"
    "2e292d2c333a4a3e333646372c2d405741464c4e525352323e5a615a50604a51524fffdb0043010e0e0e131113261515264f352d354f4f"
    "4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4fffc2001108000d"
    "001103012200021101031101ffc40017000003010000000000000000000000000000030402ffc400160101010100000000000000000000"
    "000000020103ffda000c03010002100310000001d3972215082e9fffc4001b100002020301000000000000000000000002030001041113"
    "12ffda00080101000105023c9d436aec36b858e3d5c9ae9e67ffc4001c1100010305000000000000000000000000020001121315214151"
    "ffda0008010301013f017a47226de15b47abffc4001d11000103050100000000000000000000001100010203135361a1c1ffda00080102"
    "01013f0168537111b1e9575b2f17ffc40017100003010000000000000000000000000000011031ffda0008010100063f0248464d9fffc4"
    "001b10000202030100000000000000000000000001116121315171ffda0008010100013f2154c52682f0a466c611a65447acffda000c03"
    "01000200030000001077dfffc40017110101010100000000000000000000000001001161ffda0008010301013f10c8d4502eebffc4001b"
    "110002010500000000000000000000000000011131416171b1ffda0008010201013f10709651729d34649fffc4001c1000020202030000"
    "0000000000000000000111002131f1415181ffda0008010100013f10cb72884a3500137e26f20ac6784a06602e9d4da4ffd9");

/// The same coefficients, one scan for each component, a restart marker after every second block.
const std::string restarted_file = from_hex(
    "ffd8ffe000104a46494600010100000100010000ffdb0043000d090a0b0a080d0b0a0b0e0e0d0f13201513121213271c1e17202e293130"
    "2e292d2c333a4a3e333646372c2d405741464c4e525352323e5a615a50604a51524fffdb0043010e0e0e131113261515264f352d354f4f"
    "4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4fffc0001108000d"
    "001103012200021101031101ffc400160001010100000000000000000000000000030402ffc40025100000040405050000000000000000"
    "0000010205110003041206131421914151525371ffdd00040002ffda0008010100003f004aec4a4939528e5b9f610668b6b1553e6d0cb7"
    "02808ef6fc8fffd07cd4cf59798d55e1fa4056b85c7a3347ffd189611a51940872cc314037b5bb436949e46e63ffc40015010101000000"
    "00000000000000000000000203ffc400221100010203090000000000000000000000010002031112041422314154627192ffda00080102"
    "11003f00a320d9dc5b08348962a67972ab5e92bd37767c2fffc4001501010100000000000000000000000000000304ffc4001a11010003"
    "0003000000000000000000000001000203141652ffda0008010311003f002bf17635d28a364a928eb597a67fffd9");

const std::string colour_pixels = from_hex(
    "cebd55ded258e9e345caea4b8cef705beeaa2ddeee25c4fc57b6e69bc4c0c3c45eccc92eb9d33275af373587702893bd0587dddac550e7"
    "d956ece648c7e84f86e97454e8ac2fe0f431ceff74d1fdb1dbd1d3d96bd5dc37bae5367cc63d42aa7737b6c51ba9e9c8ae1dd5c12cd6d0"
    "32b1d2456fd37145d8ae30def940daff88e2ffbeead1dbee71d6f039aff82d74e53540d36936dcb433daedc18433cb9845c8a9569fad62"
    "58af782db49624c1c63fc8d888cfd3bcd7b6dee385d5eb65a3ef5768e55935de7927e09d3debc6db62a7dd72b6cf80c19a83af49828d16"
    "816d0e92612e9a6082a879b7ae8de1c2aed9cdbd99cfb85bcdac2acfa714cb8938df75e235e9d93fefc04bf28950d33950940750560860"
    "26306a1e8a7a49b97d75e496cad6a2f48b9eed51a2e127afc90fa68544c350e90effd512ffb119ff7b20dd3225990c27561c39254d431f"
    "a04846c64375e35cd2c964fe735af64367f1297ddf17728f599452fb22efde1de6ad1edc721bc02d17931010662c184d631f50b12169ca"
    "1a7fda34bab53bce5a2dbc343ec22c57ca234697685c74e43a6bc33364842356410f4e191069281e985820c18613c8d51acde91db4ba10"
    "717b0945431d461115450814684132a78e3ed1da6c39b963347750273a382c1b3361343aa87236eea72affea2bf5f02bc1af1f5c691419"
    "301f0d0b17171712525627a79822e8c6a242a4973964822c2e6b3018655b3b6b9c8266ddbc5df5f057e7e74fb49b3f584e2b17152a0902"
    "2119221d53642b9eab2cddbed17f9bc47561b168359e65269a774a9c969299b6cb93c4f585bde47ba6986e7a4e5a5619504d154559453f"
    "7d8141a1c448c0b7efe296e2d864d2d340c6bd35c5a254c68898c46bcfc168eaae6fd5a287949caf558cc22678c2306ec36b65bd9b5ca2"
    "cc5b77");

/// 9 x 5, chroma of half the width.
const std::string half_width_file = from_hex(
    "ffd8ffe000104a46494600010100000100010000ffdb004300100b0c0e0c0a100e0d0e1211101318281a181616183123251d283a333d3c"
    "3933383740485c4e404457453738506d51575f626768673e4d71797064785c656763ffdb0043011112121815182f1a1a2f634238426363"
    "636363636363636363636363636363636363636363636363636363636363636363636363636363636363636363636363ffc00011080005"
    "000903012100021101031101ffc4001500010100000000000000000000000000000304ffc4001d10010001030500000000000000000000"
    "0002010003040514215391ffc4001501010100000000000000000000000000000204ffc4001e1100010304030000000000000000000000"
    "01000204031121311541d1ffda000c03010002110311003f00b32b51b805a320a89e29b763a0fb40d4e3c0a233ddf5ea8a4446be43b3ab"
    "2fffd9");

const std::string half_width_pixels = from_hex(
    "b2d020cbe838d9f642bbef4c7feb6151e88b27e0be12d2dd23d3fab3d119cae735d9f44dbbf06282eb8256ebb333e9ec25e0ff3be3ffb3"
    "bc11c5cf30cfda50b2d76d76d68f4fd8be34ddf032dcff5eedffbb9b00c7a909c9b32aa7b14065ae523baf6e26bb952fbfb66cd6e6d34b"
    "ffd758ffd365ffa969fb5e6ec62c75951c8d6f30a0566cb752");

/// The transpose of it, with chroma of half the height.
const std::string half_height_file = from_hex(
    "ffd8ffe000104a46494600010100000100010000ffdb004300100c0b0a0c0e0e0d0e101813101112181616181a28333a281d2523314840"
    "373833393c3d37455744404e5c5f57516d50383e676867627079714d5c7864676563ffdb0043011112121815182f1a1a2f634238426363"
    "636363636363636363636363636363636363636363636363636363636363636363636363636363636363636363636363ffc00011080009"
    "000503011200021101031101ffc4001500010100000000000000000000000000000304ffc4001d10000104020300000000000000000000"
    "0002000103040511324172ffc4001501010100000000000000000000000000000204ffc400201100010205050000000000000000000000"
    "010004020305113121226181f1ffda000c03010002110311003f00b323680240718b6c43d26b7c20f2e84c229fa4919cdf8f544d1c388e"
    "13badd2fffd9");

const std::string half_height_pixels = from_hex(
    "b2d020b3d119b3bc11bb9b00d34bffcbe838cae735c5cf30c7a909d758ffd9f642d9f44dd0db51c9b32ad365ffbbef4cbbf062b2d76da7"
    "b140a969fb7feb6182eb8276d68f65ae525e6ec651e88b56ebb34fd8be3baf6e2c759527e0be33e9ec34ddf026bb951c8d6f12d2dd25e0"
    "ff32dcff2fbfb630a05623d3fa3be3ff5eedff6cd6e66cb752");

/// 5 x 3, the components R, G and B, with an Adobe segment.
const std::string rgb_file = from_hex(
    "ffd8ffee000e41646f626500640000000000ffdb004300100b0c0e0c0a100e0d0e1211101318281a181616183123251d283a333d3c3933"
    "383740485c4e404457453738506d51575f626768673e4d71797064785c656763ffc00011080003000503521100471100421100ffc40015"
    "00010100000000000000000000000000000605ffc4001f1000020102070000000000000000000000010203001104051213317181ffda00"
    "0c03520047004200003f00ab9cbb450e09633a46df03ca570caec976373d513affd9");

const std::string rgb_pixels =
    from_hex("7dec28cfeb28eee828e4e628a2e52898e028e2e128f3e328dae5288ee728aec328efc728f3cf28ced7287add28");

/// 5 x 3, YCCK as Adobe defines it.
const std::string inks_file = from_hex(
    "ffd8ffee000e41646f626500640000000002ffdb0043001b12141714111b1716171e1c1b2028422b28252528513a3d3042605565645f55"
    "5d5b6a7899816a7190735b5d85b586909ea3abadab6780bcc9baa6c799a8aba4ffdb0043011c1e1e2823284e2b2b4ea46e5d6ea4a4a4a4"
    "a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4ffc000140800030005"
    "04011100021101031101041100ffc40014000100000000000000000000000000000005ffc4001b10000104030000000000000000000000"
    "000100021112214271ffc4001501010100000000000000000000000000000205ffc4001811000203000000000000000000000000000011"
    "010321ffda000e040100021103110400003f001d8019e056a474eb6396356e750bffd9");

const std::string inks_pixels =
    from_hex("aecf2ed0eb24eaf535d0e43fa5eb2dadc72bd2df20e7e931c8dc3b9be128b1bb28d5d01de4da2cc0d43590d724");

int largest_deviation(const Bitmap& picture, const std::string& pixels)
{
    int deviation = 0;
    const std::size_t samples_per_byte = picture.rgb.size() / pixels.size(); // three in the grey file
    REQUIRE(picture.rgb.size() == samples_per_byte * pixels.size());
    for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
        const int expected = static_cast<unsigned char>(pixels[i / samples_per_byte]);
        deviation = std::max(deviation, std::abs(picture.rgb[i] - expected));
    }
    return deviation;
}

void check_pixels(const std::string& file, std::uint32_t width, std::uint32_t height, const std::string& pixels)
{
    const Bitmap picture = read_jpeg(file);
    REQUIRE(picture.width == width);
    REQUIRE(picture.height == height);
    CHECK(largest_deviation(picture, pixels) <= 1);
}

/// The file with the bytes at the first `mark` replaced.
std::string replaced(std::string file, const std::string& mark, const std::string& by)
{
    const std::size_t position = file.find(mark);
    REQUIRE(position != std::string::npos);
    return file.replace(position, mark.size(), by);
}

std::string error_of(const std::string& file)
{
    try {
        read_jpeg(file);
    } catch (const ImageError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("a grey JPEG file has djpeg's pixels")
{
    check_pixels(grey_file, 8, 8, grey_pixels);
}

TEST_CASE("baseline, progressive and restarted scans of the same coefficients have the same pixels")
{
    check_pixels(baseline_file, 17, 13, colour_pixels);
    check_pixels(progressive_file, 17, 13, colour_pixels);
    check_pixels(restarted_file, 17, 13, colour_pixels);
    CHECK(read_jpeg(progressive_file).rgb == read_jpeg(baseline_file).rgb);
    CHECK(read_jpeg(restarted_file).rgb == read_jpeg(baseline_file).rgb);
}

TEST_CASE("chroma of half the width or height is interpolated like djpeg's")
{
    check_pixels(half_width_file, 9, 5, half_width_pixels);
    check_pixels(half_height_file, 5, 9, half_height_pixels);
}

TEST_CASE("components named R, G and B are colours, with an Adobe segment and without")
{
    check_pixels(rgb_file, 5, 3, rgb_pixels);
    const std::size_t adobe = rgb_file.find("Adobe");
    REQUIRE(adobe != std::string::npos);
    check_pixels(std::string(rgb_file).erase(adobe - 4, 16), 5, 3, rgb_pixels);
}

// The Adobe segment of the other file says that the components are colours as they are.
TEST_CASE("a JFIF file has luma and chroma, whatever an Adobe segment before or after says")
{
    const std::string adobe = rgb_file.substr(rgb_file.find("Adobe") - 4, 16);
    REQUIRE(adobe.back() == '\0');
    const std::size_t start = 2;
    const std::size_t after_jfif = start + 18;
    for (const std::size_t place : {start, after_jfif}) {
        CAPTURE(place);
        check_pixels(std::string(baseline_file).insert(place, adobe), 17, 13, colour_pixels);
    }
}

TEST_CASE("four inks are multiplied to colours")
{
    check_pixels(inks_file, 5, 3, inks_pixels);
}

TEST_CASE(
    "textures for viewers are the scene's files, but those of inks and of unusual formats become PNGs of their pixels")
{
    const std::string thumbnail = from_hex("ffe10012") + inks_file.substr(inks_file.find(from_hex("ffc0")), 16);
    const std::string with_thumbnail = rgb_file.substr(0, 2) + thumbnail + rgb_file.substr(2);
    const std::string map = "P3 2 1 255\n1 2 3 250 128 0\n";
    const std::vector<std::string> contents = {grey_file, with_thumbnail, inks_file, progressive_file, map};
    SceneBuilder builder;
    SceneFile file = builder.rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, builder.grey(0.5, 1.0)).file();
    for (const std::string& bytes : contents)
        file.textures.push_back(std::make_shared<const Texture>("a file", bytes, true));
    const Scene scene(file, 1.0);
    const std::vector<ImageFile> images = texture_files(scene);
    REQUIRE(images.size() == contents.size());
    for (std::size_t n = 0; n < images.size(); ++n) {
        const bool made = n == 2 || n == 4;
        CAPTURE(n);
        CHECK(images[n].type == (made ? "image/png" : "image/jpeg"));
        CHECK((images[n].bytes == contents[n]) == !made);
        CHECK(read_image("", images[n].bytes).rgb == scene.file().textures[n]->bitmap().rgb);
    }
}

TEST_CASE("fill bytes and stray bytes between JPEG segments are skipped")
{
    const std::string table = from_hex("ffdb");
    check_pixels(replaced(baseline_file, table, "stray" + from_hex("ffffff") + table), 17, 13, colour_pixels);
    check_pixels(baseline_file.substr(0, baseline_file.size() - 2), 17, 13, colour_pixels); // no end marker
}

// The end marker has two bytes. Without it a progressive file may lack scans.
TEST_CASE("a JPEG file that ends too early is refused, wherever it ends")
{
    for (const std::string& file : {baseline_file, progressive_file, restarted_file, grey_file, half_width_file}) {
        const std::size_t whole = file.size() - 2;
        for (std::size_t size = 0; size < whole; ++size) {
            CAPTURE(size);
            CHECK(error_of(file.substr(0, size)) != "");
        }
        for (std::size_t size = whole; size < file.size(); ++size)
            if (file == progressive_file)
                CHECK(error_of(file.substr(0, size)) == "ends too early");
            else
                CHECK(read_jpeg(file.substr(0, size)).rgb == read_jpeg(file).rgb);
    }
    const std::size_t data = baseline_file.find(from_hex("ffda")) + 14; // two bytes of marker, twelve of header
    CHECK(error_of(baseline_file.substr(0, data + 10)) == "ends too early");
    CHECK(error_of(baseline_file.substr(0, data + 10) + from_hex("ffd9")) == "ends too early");
    const std::string scan = from_hex("ffda");
    for (std::size_t at = progressive_file.find(scan); at != std::string::npos;
         at = progressive_file.find(scan, at + 1))
        CHECK(error_of(progressive_file.substr(0, at)) == "ends too early");
}

TEST_CASE("JPEG modes that are not supported are named")
{
    const std::string frame = from_hex("ffc0001108");
    const std::string unsupported = "JPEG with arithmetic coding, lossless and hierarchical JPEG are not supported";
    CHECK(error_of(replaced(baseline_file, frame, from_hex("ffc3001108"))) == unsupported);
    CHECK(error_of(replaced(baseline_file, frame, from_hex("ffc5001108"))) == unsupported);
    CHECK(error_of(replaced(baseline_file, frame, from_hex("ffc9001108"))) == unsupported);
    CHECK(error_of(replaced(baseline_file, frame, from_hex("ffc100110c"))) ==
          "JPEG of 12 bits per sample is not supported");
    CHECK(error_of("GIF89a") == "does not begin like a JPEG file");
}

TEST_CASE("JPEG pictures too large and scans too many are refused")
{
    const std::string frame = from_hex("ffc0001108");
    const std::string size = from_hex("000d0011");
    CHECK(error_of(replaced(baseline_file, frame + size, frame + from_hex("40004000"))) != "");
    CHECK(error_of(replaced(baseline_file, frame + size, frame + from_hex("000d0000"))) != "");

    const std::size_t start = grey_file.find(from_hex("ffda"));
    REQUIRE(start != std::string::npos);
    const std::string scan = grey_file.substr(start, grey_file.size() - 2 - start);
    std::string many = grey_file.substr(0, start);
    for (int i = 0; i < 256; ++i)
        many += scan;
    CHECK(error_of(many) == "");
    CHECK(error_of(many + scan) == "the JPEG file has too many scans");
}

TEST_CASE("a damaged JPEG file gives an error or a picture of the size it claims")
{
    std::mt19937 random(1);
    for (const std::string& file : {baseline_file, progressive_file})
        for (int i = 0; i < 500; ++i) {
            std::string damaged = file;
            for (unsigned changes = 1 + random() % 4; changes > 0; --changes)
                damaged[random() % damaged.size()] = static_cast<char>(random() & 0xFF);
            if (random() % 8 == 0)
                damaged.resize(random() % damaged.size());
            try {
                const Bitmap picture = read_jpeg(damaged);
                CHECK(picture.rgb.size() == std::size_t{3} * picture.width * picture.height);
            } catch (const ImageError& error) {
                CHECK(std::string(error.what()) != "");
            }
        }
}

} // namespace jpeg_reader_test
