#include "study/report.h"

#include "scene/input_error.h"
#include "scene/scratch_folder.h"

#include <doctest/doctest.h>

namespace report_test {

using namespace multipath;

namespace {

bool holds(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("a page holds its figures and refers to nothing else")
{
    const ScratchFolder folder;
    folder.write("plot.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"><title>plot</title></svg>\n");
    folder.write("picture.png", "foobar");
    const Report report = {ReportHeading{1, "Title & more"}, ReportParagraph{"some `a < b` *and* 3 * 4"},
                           ReportTable{{"x"}, {{"1"}, {"2"}}},
                           ReportFigures{{{"plot.svg", "a plot", "multipath study"},
                                          {"picture.png", "a \"picture\"", "multipath solve"}}}};
    const std::string html = report_html(report, folder.path(""), {"multipath 1", "command: multipath paper --quick"});
    CHECK(holds(html, "<title>Title &amp; more</title>"));
    CHECK(holds(html, "<meta name=\"multipath\" content=\"command: multipath paper --quick\">"));
    CHECK(holds(html, "some <code>a &lt; b</code> <em>and</em> 3 * 4"));
    CHECK(holds(html, "<tr><td>2</td></tr>"));
    CHECK(holds(html, "<title>plot</title>"));
    CHECK(holds(html, "src=\"data:image/png;base64,Zm9vYmFy\""));
    CHECK(holds(html, "alt=\"a &quot;picture&quot;\""));
    CHECK(!holds(html, "src=\"http"));
    CHECK(!holds(html, "href="));
}

TEST_CASE("a page without one of its figures is an error")
{
    const ScratchFolder folder;
    const Report report = {ReportFigures{{{"missing.svg", "", ""}}}};
    CHECK_THROWS_AS((void)report_html(report, folder.path(""), {}), InputError);
}

TEST_CASE("the same report as Markdown")
{
    const Report report = {ReportHeading{2, "Part"}, ReportParagraph{"took 3 s"},
                           ReportTable{{"a", "b"}, {{"1|2", "3"}}},
                           ReportFigures{{{"plot.svg", "a plot", "multipath study x"}}}};
    CHECK(report_markdown(report, {"command: multipath paper"}) == "## Part\n\n"
                                                                   "took 3 s\n\n"
                                                                   "| a | b |\n"
                                                                   "| --- | --- |\n"
                                                                   "| 1\\|2 | 3 |\n\n"
                                                                   "![plot.svg](plot.svg)\n\n"
                                                                   "a plot\n\n"
                                                                   "```console\nmultipath study x\n```\n\n"
                                                                   "---\n\n"
                                                                   "    command: multipath paper\n");
}

} // namespace report_test
