#include "cli/options/completion.h"

#include <doctest/doctest.h>

namespace completion_test {

using namespace multipath;

TEST_CASE("the completion offers what the help shows, and no hidden option")
{
    const CommandTable table = {
        "solve",
        "solve a scene",
        {{"SCENE.obj", false, false, {".obj"}}},
        {{"", {{"method", 'm', "NAME", "", "The method.", false, {"local", "reuse"}}, {"out", 0, "FOLDER"}}},
         {"", {{"secret", 0, "", "", "No.", false, {}, true}}}}};
    const std::string script = bash_completion({table});
    for (const char* word : {"solve", "--method | -m", "local reuse", "--help", ".obj", "--out) _multipath_folders"})
        CHECK_MESSAGE(script.find(word) != std::string::npos, word);
    CHECK(script.find("secret") == std::string::npos);
}

} // namespace completion_test
