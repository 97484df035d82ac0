#include "image/camera_file.h"

#include "scene/input_problem.h"
#include "scene/scratch_folder.h"

#include <doctest/doctest.h>

#include <string>

namespace camera_file_test {

using namespace multipath;

namespace {

const ScratchFolder folder;

Camera camera_of(const std::string& text)
{
    return read_camera_file(folder.write("view.json", text));
}

std::string problem(const std::string& text)
{
    return problem_of([&] { camera_of(text); });
}

} // namespace

TEST_CASE("a view is read in any order and spacing, and what it leaves out has defaults")
{
    const Camera camera =
        camera_of("{\"fov\":35.5,\n \"up\":[0, 0,1],\r\n\t\"target\": [1,2 ,3.5e0],\"eye\":[-1,0,+0]}\n");
    CHECK(camera.eye == Vec3{-1, 0, 0});
    CHECK(camera.target == Vec3{1, 2, 3.5});
    CHECK(camera.up == Vec3{0, 0, 1});
    CHECK(camera.field_of_view == 35.5);
    const Camera bare = camera_of("{\"eye\":[1,0,0],\"target\":[0,0,0]}");
    CHECK(bare.up == Vec3{0, 1, 0});
    CHECK(bare.field_of_view == 60.0);
    CHECK(camera_of("\xef\xbb\xbf{\"eye\":[1,0,0],\"target\":[0,0,0]}").eye == Vec3{1, 0, 0});
}

TEST_CASE("what is no view is refused with its line")
{
    const std::string start = "{\"eye\":[1,0,0],\n\"target\":[0,0,0]";
    CHECK(problem(start + "}").empty());
    CHECK(contains(problem(""), "view.json:1: expected an object"));
    CHECK(contains(problem("[]"), "expected an object"));
    CHECK(contains(problem("{}"), "view.json: no `eye`"));
    CHECK(contains(problem("{\"eye\":[1,0,0]}"), "no `target`"));
    CHECK(contains(problem(start), "view.json:2: expected a comma or the end of the object"));
    CHECK(contains(problem(start + ",\n}"), "view.json:3: expected a key"));
    CHECK(contains(problem(start + ",\"zoom\":1}"), "view.json:2: unknown key `zoom`"));
    CHECK(contains(problem(start + ",\"eye\":[1,0,1]}"), "`eye` is given again"));
    CHECK(contains(problem(start + ",\"fov\":0}"), "1 to 179"));
    CHECK(contains(problem(start + ",\"fov\":nan}"), "expected a number, got `nan`"));
    CHECK(contains(problem(start + ",\"up\":[0,1]}"), "three numbers"));
    CHECK(contains(problem(start + ",\"up\":[0,1,0,0]}"), "three numbers"));
    CHECK(contains(problem(start + ",\"up\":[0,1e99,0]}"), "expected a number"));
    CHECK(contains(problem(start + ",\"up\":[2,0,0]}"), "looks along `up`"));
    CHECK(contains(problem(start + "} more"), "more text after the view"));
    CHECK(contains(problem(start + "}" + std::string(1, '\0')), "more text after the view"));
    CHECK(contains(problem("{\"eye\":[1,0,0],\"target\":[1,0,0]}"), "where it stands"));
    CHECK(contains(problem("{\"eye"), "a key has no end"));
    CHECK(contains(problem_of([] { read_camera_file(folder.path("none.json")); }), "cannot be read"));
    CHECK(contains(problem_of([] { read_camera_file("/"); }), "cannot be read"));
}

} // namespace camera_file_test
