#include "scene/mtl_path.h"

#include "input_problem.h"
#include "scratch_folder.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace mtl_path_test {

using namespace multipath;

namespace {

/// What each of the found files holds; the files hold their own names.
std::vector<std::string> found_in(const ScratchFolder& folder, const std::string& names)
{
    std::vector<std::string> texts;
    const std::string obj = folder.path("room.obj");
    for (const std::string& path : find_mtl_files(names, {obj, 3})) {
        std::ifstream file(path);
        std::getline(file, texts.emplace_back());
    }
    return texts;
}

} // namespace

TEST_CASE("names of material files may be several, quoted, with blanks, backslashes or the wrong case")
{
    using Names = std::vector<std::string>;
    const ScratchFolder folder;
    for (const char* name : {"a.mtl", "b.mtl", "a b.mtl", "c d e.mtl", "Sub/F.mtl", "x.MTL", "X.mtl"})
        folder.write(name, name);

    CHECK(found_in(folder, "a.mtl") == Names{"a.mtl"});
    CHECK(found_in(folder, "a.mtl b.mtl") == Names{"a.mtl", "b.mtl"});
    CHECK(found_in(folder, "a b.mtl") == Names{"a b.mtl"});
    CHECK(found_in(folder, "c d e.mtl a.mtl") == Names{"c d e.mtl", "a.mtl"});
    CHECK(found_in(folder, "\"a b.mtl\" 'b.mtl' a.mtl") == Names{"a b.mtl", "b.mtl", "a.mtl"});
    CHECK(found_in(folder, ".\\SUB\\f.MTL") == Names{"Sub/F.mtl"});
    CHECK(found_in(folder, "Sub/../b.mtl") == Names{"b.mtl"});
    CHECK(found_in(folder, "X.mtl") == Names{"X.mtl"});
    CHECK(found_in(folder, "x.mtl") == Names{"X.mtl"}); // of the two, the first by name
    CHECK(found_in(folder, folder.path("a.mtl")) == Names{"a.mtl"});
}

TEST_CASE("a material file that does not exist is named, with the place of the statement")
{
    const ScratchFolder folder;
    folder.write("a.mtl", "");
    folder.write("folder.mtl/b.mtl", "");
    const auto problem = [&](const std::string& names) { return problem_of([&] { found_in(folder, names); }); };
    CHECK(contains(problem("a.mtl none.mtl"), "room.obj:3: material file `none.mtl` not found in the folder `"));
    CHECK(contains(problem("folder.mtl"), "material file `folder.mtl` not found"));
    CHECK(contains(problem(""), "`mtllib` without a name"));
    CHECK(contains(problem("\""), "material file `\"` not found"));
    std::string many;
    for (int i = 0; i < 100; ++i)
        many += "a.mtl ";
    CHECK(contains(problem(many), "more than 32 words"));
}

} // namespace mtl_path_test
