#include "base/errors.h"
#include "base/file_bytes.h"
#include "commands/commands.h"
#include "commands/solve/formats.h"
#include "commands/solve/solve_job.h"
#include "radiosity/run/solve.h"

#include "cli/options/command_line.h"
#include "scene/scratch_folder.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

namespace formats_test {

using namespace multipath;

namespace {

Scene room_with_lamp()
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.6, 0.0);
    const std::uint32_t lamp = builder.grey(0.3, 3.0);
    return builder.room({0, 0, 0}, {2, 1, 3}, {wall, lamp, wall, wall, wall, wall}).scene(0.5);
}

struct SolvedRoom
{
    SolveJob job = read_solve_job(CommandLine(
        solve_command().table, {"room.obj", "--lines", "4096", "--size", "32x24", "--threads", "1", "--quiet"}));
    Scene scene = room_with_lamp();
    Solution solution = solve(scene, job.options, [](double) {});

    /// The bytes of a file with this extension.
    std::string bytes(std::string_view extension) const
    {
        const ScratchFolder folder;
        const std::string path = folder.path("room" + std::string(extension));
        std::vector<PlannedOutput> outputs = open_solution_outputs(job.line, {path}, {}, job.pictures);
        write_outputs(outputs, job, scene, solution, "the state");
        return bytes_of_file(path);
    }
};

} // namespace

TEST_CASE("every format has an extension and bytes of its own, which are the same when they are asked for again")
{
    SolvedRoom room;
    std::set<std::string_view> extensions;
    std::set<std::string> all_bytes;
    for (const OutputFormat& format : output_formats()) {
        CAPTURE(std::string(format.name));
        CHECK(extensions.insert(format.name).second);
        const std::string bytes = room.bytes(format.name);
        CHECK_FALSE(bytes.empty());
        CHECK(all_bytes.insert(bytes).second);
        CHECK(room.bytes(format.name) == bytes);
    }
}

TEST_CASE("a file's extension in upper or lower case tells its kind, and the refusal of another one lists them all")
{
    for (const OutputFormat& format : output_formats())
        CHECK(kind_of("a folder/room" + std::string(format.name)) == format.kind);
    CHECK(kind_of("ROOM.PLY") == FormatKind::mesh);
    CHECK(kind_of("-") == output_formats().front().kind);
    std::string message;
    try {
        (void)kind_of("room.txt");
    } catch (const UsageError& error) {
        message = error.what();
    }
    for (const OutputFormat& format : output_formats())
        CHECK(message.find(format.name) != std::string::npos);
}

TEST_CASE("the default outputs have the name of the input, wherever that is, and the first format is among them")
{
    const std::vector<std::string> outputs = default_outputs("../rooms/a.room.obj");
    CHECK(outputs.front() == "a.room" + std::string(output_formats().front().name));
    CHECK(default_outputs("room").size() == outputs.size());
}

TEST_CASE("every quantity that pictures show has a value for each patch and a picture of its own")
{
    std::set<std::string_view> names;
    std::set<std::string> pictures;
    for (const ShownQuantity& shown : shown_quantities()) {
        SolvedRoom room;
        room.solution.standard_error = room.solution.radiosity;
        room.job.pictures.shown = shown;
        CAPTURE(std::string(shown.name));
        CHECK(names.insert(shown.name).second);
        CHECK(shown.values(room.scene, room.solution, 1).size() == room.scene.patch_count());
        CHECK(pictures.insert(room.bytes(".ppm")).second);
    }
}

} // namespace formats_test
