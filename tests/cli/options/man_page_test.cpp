#include "cli/options/man_page.h"

#include <doctest/doctest.h>

namespace man_page_test {

using namespace multipath;

namespace {

bool contains(const std::string& text, const std::string& part)
{
    CAPTURE(text);
    CAPTURE(part);
    return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("the manual shows commands with both forms of their options, and topics as they are")
{
    const CommandTable table = {
        "solve",
        "solve a scene",
        {{"SCENE.obj"}},
        {{"Budget", {{"lines", 'n', "N", "2^20", "How many."}, {"quiet", 0, "", "", "No word."}}}},
        "  multipath solve room.obj"};
    const std::string page = man_page({table}, {{"exit-codes", "what is returned", "  0  done\n"}});
    CHECK(contains(page, ".SS solve\n\\fBmultipath solve\\fR [\\fIOPTIONS\\fR] \\fISCENE.obj\\fR\n"));
    CHECK(contains(page, ".TP\n\\fB\\-n\\fR, \\fB\\-\\-lines\\fR \\fIN\\fR\nHow many. (default 2^20)\n"));
    CHECK(contains(page, ".TP\n\\fB\\-\\-quiet\\fR\nNo word.\n"));
    CHECK(contains(page, ".nf\n  multipath solve room.obj\n.fi\n"));
    CHECK(contains(page, ".SH EXIT\\-CODES\n.PP\n.nf\n  0  done\n.fi\n"));
}

TEST_CASE("nothing in a text is a command of roff")
{
    const std::string page = man_page({}, {{"odd", "", ".so /etc/passwd\n'br\na\\b isn't .x\n"}});
    CHECK(contains(page, "\n\\&.so /etc/passwd\n\\&\\(aqbr\na\\eb isn\\(aqt .x\n"));
}

TEST_CASE("hidden options are not in the manual")
{
    CommandTable table = {"solve", "solve a scene", {}, {{"Tests", {{"secret", 0, "", "", "No.", false, {}, true}}}}};
    CHECK_FALSE(man_page({table}, {}).find("secret") != std::string::npos);
}

} // namespace man_page_test
