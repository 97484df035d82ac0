#include "cli/completion.h"
#include "cli/completion_words.h"

#include <doctest/doctest.h>

namespace completion_test {

using namespace multipath;

TEST_CASE("a completion describes an option by the first phrase of its help")
{
    CHECK(first_phrase("Where to write; by extension .ppm or .png.") == "Where to write");
    CHECK(first_phrase("Most memory, such as 1.5GB. Without it, all.") == "Most memory, such as 1.5GB");
    CHECK(first_phrase("What pictures show: radiosity.") == "What pictures show");
    CHECK(first_phrase("Print nothing.") == "Print nothing");
    CHECK(first_phrase("").empty());
}

TEST_CASE("completions offer what the help shows, and no hidden option")
{
    const CommandTable table = {
        "solve",
        "solve a scene",
        {{"SCENE.obj", false, false, {".obj"}}},
        {{"", {{"method", 'm', "NAME", "", "Isn't [shown].", false, {"local", "reuse"}}, {"out", 0, "FOLDER"}}},
         {"", {{"secret", 0, "", "", "No.", false, {}, true}}}}};
    for (const auto& script : {bash_completion({table}), zsh_completion({table}), fish_completion({table})}) {
        CAPTURE(script);
        for (const char* word : {"solve", "method", "local reuse", "help", ".obj"})
            CHECK(script.find(word) != std::string::npos);
        CHECK(script.find("secret") == std::string::npos);
    }
    CHECK(zsh_completion({table}).find("'(-m --method)'{-m,--method=}'[Isn'\\''t \\[shown\\]]:NAME:(local reuse)'") !=
          std::string::npos);
    CHECK(zsh_completion({table}).find("'1:SCENE.obj:_files -g \"*.obj\"'") != std::string::npos);
    CHECK(zsh_completion({table}).find("_files -/") != std::string::npos);
}

} // namespace completion_test
