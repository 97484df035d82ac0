#include "commands/options/picture_options.h"

#include "scene/scene_builder.h"
#include "scene/scratch_folder.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace picture_options_test {

using namespace multipath;

namespace {

const ScratchFolder folder;

} // namespace

TEST_CASE("a view from a file is the one that options give")
{
    const CommandTable table = {"solve", "solve a scene", {"SCENE.obj", 1, 1}, {picture_option_group()}};
    const auto options = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "room.obj");
        return read_picture_options(CommandLine(table, arguments), 1);
    };
    const std::string path =
        folder.write("slanted.json", "{\"eye\":[1,2,3],\"target\":[4,-5,6],\"up\":[1,0.5,2],\"fov\":35}");
    const std::string other = folder.write("other.json", "{\"eye\":[0,0,0],\"target\":[0,0,1]}");
    const PictureOptions given = options({"--eye", "1,2,3", "--target", "4,-5,6", "--up", "1,0.5,2", "--fov", "35"});
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, builder.grey(0.5, 1.0));
    const Scene scene = builder.scene(1.0);
    const Camera expected = camera_for(scene, given, given.views.front());
    CHECK(length(normalized(expected.up) - normalized({1, 0.5, 2})) < 1e-15); // rounding
    for (const PictureOptions& read : {options({"--camera", path}), options({"--camera", path, "--camera", other})}) {
        const Camera camera = camera_for(scene, read, read.views.front());
        CHECK(camera.eye == expected.eye);
        CHECK(camera.target == expected.target);
        CHECK(length(normalized(camera.up) - normalized(expected.up)) < 1e-15); // the length has no meaning
        CHECK(camera.field_of_view == expected.field_of_view);
    }
}

} // namespace picture_options_test
