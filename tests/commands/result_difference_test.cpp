#include "commands/result_difference.h"

#include "export/glb.h"
#include "export/mesh_scenes.h"
#include "export/obj_colours.h"
#include "export/ply.h"
#include "export/svg_plot.h"
#include "image/png.h"
#include "image/ppm.h"
#include "scene/input_error.h"
#include "study/report.h"

#include "scene/scratch_folder.h"

#include <doctest/doctest.h>

namespace result_difference_test {

using namespace multipath;

namespace {

const std::string table = "# multipath 0.1.0\n# command: multipath x\n# seed: 1\n# level: 3\n"
                          "name,value,seconds\na,1,0.5\nb,2,0.25\n";

std::string with(std::string text, const std::string& part, const std::string& other)
{
    const std::size_t at = text.find(part);
    REQUIRE(at != std::string::npos);
    return text.replace(at, part.size(), other);
}

std::string text_of(const std::string& then, const std::string& now)
{
    return table_difference(then, now, "t.csv").text;
}

ScreenImage image()
{
    return {2, 2, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}};
}

/// A report of one time, one number and one figure.
std::string report(const std::string& time, const std::string& number, const std::string& figure,
                   const std::string& across, const std::string& folder)
{
    const ScratchFolder scratch;
    scratch.write("f.svg", svg_head(9, 9, "f",
                                    {"command: multipath study --against " + across + " --reference " + folder +
                                     "/reference-up.csv --replicates 2"}) +
                               figure + svg_end());
    const std::string command = "multipath study --reference " + folder + "/reference-up.csv";
    return report_html({ReportParagraph{"It took {{" + time + "}} for " + number},
                        ReportFigures{{{"f.svg", "caption", command}}}, ReportParagraph{"after"}},
                       scratch.path(""), {"multipath 0.1.0 at " + time});
}

} // namespace

TEST_CASE("tables that differ in seconds only have the same result")
{
    CHECK(text_of(table, table).empty());
    CHECK_FALSE(table_difference(table, table, "t.csv").only_times);
    const ResultDifference times = table_difference(table, with(table, "0.25", "0.5"), "t.csv");
    CHECK(times.text.empty());
    CHECK(times.only_times);
    const ResultDifference more = table_difference(table, with(with(table, "0.25", "0.5"), "b,2", "b,3"), "t.csv");
    CHECK_FALSE(more.text.empty());
    CHECK_FALSE(more.only_times);
}

TEST_CASE("the first differing cell of a table is named, and the largest difference")
{
    CHECK(text_of(table, with(table, "b,2", "b,4")) ==
          "1 of 6 cells differs, line 7, column value: then `2`, now `4`; relative difference 0.5");
    CHECK(text_of(table, with(with(table, "b,2", "b,2.02"), "a,1", "a,-1")) ==
          "2 of 6 cells differ, first line 6, column value: then `1`, now `-1`; relative difference at most 2");
    CHECK(text_of(table, with(table, "b,2", "c,2")) == "1 of 6 cells differs, line 7, column name: then `b`, now `c`");
    CHECK(text_of(table, with(table, "b,2", "b,")) == "1 of 6 cells differs, line 7, column value: then `2`, now ``");
}

TEST_CASE("tables of other sizes, and with other comments than those of the command, differ")
{
    CHECK(text_of(table, with(table, "b,2,0.25\n", "")) == "other number of rows: then 2, now 1");
    CHECK(text_of(table, "name,value\na,1\n") == "other columns: then `seconds`, now ``");
    CHECK(text_of(table, with(table, "value", "cost")) == "other columns: then `value`, now `cost`");
    CHECK(text_of(table, with(table, "level: 3", "level: 4")) == "comments differ: then `level: 3`, now `level: 4`");
    CHECK(text_of(with(table, "# level: 3\n", ""), table) == "comments differ: then ``, now `level: 3`");
    CHECK(text_of(table, with(table, "0.1.0\n# command: multipath x\n# seed: 1", "0.2.0\n# command: multipath y"))
              .empty());
    CHECK_THROWS_AS(text_of("a,b\n1\n", table), InputError);
}

TEST_CASE("pixels of a PPM are counted, its comment is not compared")
{
    ScreenImage other = image();
    CHECK(ppm_difference(ppm_bytes(image(), "one"), ppm_bytes(other, "another comment")).text.empty());
    other.bytes[11] = 1;
    CHECK(ppm_difference(ppm_bytes(image(), "one"), ppm_bytes(other)).text ==
          "1 of 4 pixels differs, that in column 1 of row 1 (both from 0), by 10 of 255");
    other.bytes[6] = 7;
    other.bytes[8] = 0;
    CHECK(ppm_difference(ppm_bytes(image()), ppm_bytes(other)).text ==
          "2 of 4 pixels differ, first that in column 0 of row 1 (both from 0), by at most 10 of 255");
    other = {4, 1, other.bytes};
    CHECK(ppm_difference(ppm_bytes(image()), ppm_bytes(other)).text == "other size: then 2x2, now 4x1");
}

TEST_CASE("a PPM that is cut off or has no sense is damaged, wherever that is")
{
    const std::string whole = ppm_bytes(image(), "comment");
    for (std::size_t size = 3; size < whole.size(); ++size)
        CHECK(ppm_difference(whole.substr(0, size), whole).text == "the picture is damaged");
    for (const char* bytes :
         {"P6\n-2 -2\n255\nabcdefghijkl", "P6\n2 2\n65535\nabc", "P6\nx y\n255\n", "P6\n99999 99999\n255\n"})
        CHECK(ppm_difference(bytes, whole).text == "the picture is damaged");
}

TEST_CASE("a PNG differs where its pixels do")
{
    ScreenImage other = image();
    CHECK(png_difference(png_bytes(image(), "one"), png_bytes(other, "another comment")).text.empty());
    other.bytes[0] = 200;
    CHECK(png_difference(png_bytes(image()), png_bytes(other)).text.find("other pixels: compressed ") == 0);
    CHECK(png_difference(png_bytes(image()), png_bytes({4, 1, other.bytes})).text ==
          "other size or format of the picture");
    CHECK(png_difference(png_bytes(image()).substr(0, 40), png_bytes(image())).text == "the picture is damaged");
}

TEST_CASE("the first differing line of a drawing is named, what it says of its command is not compared")
{
    const auto drawing = [](const std::string& fact, const std::string& text) {
        return svg_head(10, 10, "title", {"multipath 0.1.0", fact}) + svg_text(1, 2, text, SvgAnchor::start) +
               svg_end();
    };
    const std::string one = drawing("seed: 1", "a text that is 3 long");
    CHECK(drawing_difference(one, drawing("seed: 12345678", "a text that is 3 long")).text.empty());
    CHECK(drawing_difference(one, drawing("seed: 1", "a text that is 4 long")).text ==
          "line 7 differs: then `a text that is 3 long</text>`, now `a text that is 4 long</text>`");
    CHECK(drawing_difference(one, one.substr(0, one.size() - 4)).text == "line 8 differs: then `</svg>`, now `</s`");
    CHECK(drawing_difference(one, one + "x").text == "line 9 differs: then ``, now `x`");
    CHECK(drawing_difference("", "x").text == "line 1 differs: then ``, now `x`");
}

TEST_CASE("reports may differ in times, in figures with seconds across, and in their folders")
{
    const std::string one = report("3 s", "5", "<a/>", "lines", "paper");
    CHECK_FALSE(report_difference(one, one).only_times);
    const ResultDifference times = report_difference(one, report("4 s", "5", "<a/>", "lines", "'my paper'"));
    CHECK(times.text.empty());
    CHECK(times.only_times);
    CHECK(report_difference(one, report("3 s", "6", "<a/>", "lines", "paper")).text.find("</span> for 6</p>`") !=
          std::string::npos);
    CHECK_FALSE(report_difference(one, report("3 s", "5", "<b/>", "lines", "paper")).text.empty());
    const std::string seconds = report("3 s", "5", "<a/>", "seconds", "paper");
    CHECK(report_difference(seconds, report("3 s", "5", "<b/>", "seconds", "paper")).only_times);
    CHECK_FALSE(report_difference(seconds, report("3 s", "6", "<b/>", "seconds", "paper")).text.empty());
    CHECK_FALSE(report_difference(seconds, one).text.empty());
}

TEST_CASE("meshes differ where their vertices and faces do, not in their records")
{
    const Scene scene = walls_that_do_not_match().scene(1.0);
    std::vector<Rgb> radiosity = some_values(scene);
    const ScreenColour colour = [](Rgb value) { return 0.5 * value; };
    const auto ply = [&](const Scene& room, const char* comment) {
        return ply_bytes(patch_mesh(room, flat_corners(radiosity), {}), radiosity, colour, {comment});
    };
    const auto glb = [&](const Scene& room, const char* comment) {
        return glb_bytes(patch_mesh(room, flat_corners(radiosity), {}), room, 0.5, {comment});
    };
    const auto obj = [&](const Scene& room, const char* comment) {
        return obj_text(patch_mesh(room, flat_corners(radiosity), {}), room, colour, {comment});
    };
    const std::string ply_then = ply(scene, "command: a");
    const std::string glb_then = glb(scene, "command: a");
    const std::string obj_then = obj(scene, "command: a");
    CHECK(ply_difference(ply_then, ply(scene, "command: longer")).text.empty());
    CHECK(glb_difference(glb_then, glb(scene, "command: [longer] \"]\"")).text.empty());
    CHECK(obj_difference(obj_then, obj(scene, "command: longer")).text.empty());

    const Scene finer = walls_that_do_not_match().scene(0.5);
    const std::vector<Rgb> before = radiosity;
    radiosity = some_values(finer);
    CHECK(ply_difference(ply_then, ply(finer, "command: a")).text.find("the descriptions") == 0);
    CHECK(glb_difference(glb_then, glb(finer, "command: a")).text.find("the descriptions") == 0);
    radiosity = before;
    radiosity[0].g += 0.25;
    CHECK(ply_difference(ply_then, ply(scene, "command: a")).text.find("the vertices or faces differ, from byte") == 0);
    CHECK(glb_difference(glb_then, glb(scene, "command: a")).text.find("the vertices or faces differ, from byte") == 0);
    CHECK(obj_difference(obj_then, obj(scene, "command: a")).text ==
          "line 2 differs: then `0 0 0 0.1250 0.2500 0.0625`, now `0 0 0 0.1250 0.3750 0.0625`");

    // Counted from 1, the end of the header included: 11 bytes and 3.
    CHECK(ply_difference("ply\nend_header\nabc", "ply\nend_header\nabd").text ==
          "the vertices or faces differ, from byte 14 of 14 on");

    for (const std::size_t length : {std::size_t{0}, std::size_t{10}, std::size_t{30}, ply_then.size() / 2}) {
        CHECK_FALSE(ply_difference(ply_then, ply_then.substr(0, length)).text.empty());
        CHECK_FALSE(glb_difference(glb_then, glb_then.substr(0, length)).text.empty());
    }
}

} // namespace result_difference_test
