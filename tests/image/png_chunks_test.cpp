#include "image/png.h"
#include "image/png_reader.h"

#include <doctest/doctest.h>

#include <string>

namespace png_chunks_test {

using namespace multipath;

namespace {

std::string small_png()
{
    return png_bytes({2, 1, {1, 2, 3, 4, 5, 6}}, "what it is");
}

} // namespace

TEST_CASE("the chunks of a PNG are those that were written, to the last byte")
{
    const std::string png = small_png();
    const std::vector<PngChunk> chunks = png_chunks(png);
    REQUIRE(chunks.size() == 5);
    CHECK(chunks[0].type == "IHDR");
    CHECK(chunks[0].data.size() == 13);
    CHECK(chunks[2].type == "tEXt");
    CHECK(chunks[2].data == std::string("Comment\0what it is", 18));
    CHECK(chunks[4].type == "IEND");
    CHECK(chunks[4].data.data() + 4 == png.data() + png.size());
}

TEST_CASE("the comment is read as it was written, be it ASCII or not")
{
    for (const std::string text :
         {"plain; and \"quoted\"\nin two lines", "\xc3\xa4\xe2\x82\xac\xf0\x9f\x92\xa1.obj", "a"})
        CHECK(png_comment(png_bytes({1, 1, {1, 2, 3}}, text)) == std::optional<std::string_view>(text));
    CHECK(png_comment(png_bytes({1, 1, {1, 2, 3}}, "bad \xff, cut \xe2\x82, bell \a")) ==
          std::optional<std::string_view>("bad \xc3\xbf, cut \xc3\xa2\xc2\x82, bell ?"));
    CHECK_FALSE(png_comment(png_bytes({1, 1, {1, 2, 3}})));
}

TEST_CASE("ASCII is in the chunk that every reader knows, the rest in that for UTF-8")
{
    CHECK(png_chunks(png_bytes({1, 1, {1, 2, 3}}, "room")).at(2).type == "tEXt");
    const std::string named = png_bytes({1, 1, {1, 2, 3}}, "\xc3\xa4");
    const PngChunk chunk = png_chunks(named).at(2);
    CHECK(chunk.type == "iTXt");
    CHECK(chunk.data == std::string("Comment\0\0\0\0\0\xc3\xa4", 14)); // ISO/IEC 15948, 11.3.4.5
}

} // namespace png_chunks_test
