// Scenes of every kind, by every method (scene_judge.h).
// `make sweep SEEDS=1-1000` judges the scenes of these numbers, `make sweep OBJ=FOLDER` the files of a folder.

#include "radiosity/run/trapped_light.h"
#include "scene/daylight.h"
#include "scene/obj/obj_reader.h"
#include "sweep/random_scene.h"
#include "sweep/scene_judge.h"

#include <algorithm>
#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <string>
#include <vector>

namespace sweep_test {

using namespace multipath;

namespace {

std::string variable(const char* name)
{
    const char* const value = std::getenv(name);
    return value ? value : "";
}

void judge_number(std::uint64_t key, std::uint32_t most_patches)
{
    const RandomScene random = random_scene(key, most_patches);
    if (patch_of_trapped_light(random.scene))
        return;
    for (const std::string& fault : faults(random.scene, random.lines, random.convex, key))
        FAIL_CHECK("scene " << key << ", " << random.kind << ", " << random.lines << " lines, " << fault);
}

/// A file as it is and two-sided, lit by itself or else by a sky.
void judge_file(const std::string& path, bool two_sided)
{
    ObjChanges changes;
    changes.lit_from_outside = true;
    SceneFile file;
    try {
        file = read_obj(path, changes);
    } catch (const std::exception& error) {
        MESSAGE("not judged: " << std::string(error.what()));
        return;
    }
    if (std::none_of(file.materials.begin(), file.materials.end(),
                     [](const Material& m) { return mean(m.emittance) > 0.0; }))
        add_sky(file, {1.0, 1.0, 1.0});
    const double size = patch_size_for_count(file.surfaces, 2000);
    const Scene scene(std::move(file), size, two_sided);
    if (patch_of_trapped_light(scene)) {
        MESSAGE(path << " not judged: light is trapped");
        return;
    }
    for (const std::string& fault : faults(scene, 20 * scene.patch_count(), false, 1))
        FAIL_CHECK(std::string(path + (two_sided ? ", two-sided, " : ", ") + fault));
}

} // namespace

TEST_CASE("in scenes of every kind every method finds the light of particles")
{
    for (std::uint64_t key = 1; key <= 32; ++key)
        judge_number(key, 300);
}

TEST_CASE("sweep of scenes" * doctest::test_suite("sweep") * doctest::skip(variable("SEEDS").empty()))
{
    const std::string range = variable("SEEDS");
    const std::uint64_t first = std::stoull(range);
    const std::size_t dash = range.find('-');
    const std::uint64_t last = dash == std::string::npos ? first : std::stoull(range.substr(dash + 1));
    for (std::uint64_t key = first; key <= last; ++key)
        judge_number(key, 20000);
}

TEST_CASE("sweep of files" * doctest::test_suite("sweep") * doctest::skip(variable("OBJ").empty()))
{
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(variable("OBJ")))
        if (entry.path().extension() == ".obj")
            paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    REQUIRE(!paths.empty());
    for (const std::string& path : paths)
        for (const bool two_sided : {false, true})
            judge_file(path, two_sided);
}

} // namespace sweep_test
