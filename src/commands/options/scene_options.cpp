#include "commands/options/scene_options.h"

#include "base/file_bytes.h"
#include "base/platform/files.h"
#include "base/platform/machine.h"
#include "base/text_format.h"
#include "cli/options/number_text.h"
#include "commands/options/memory_limit.h"
#include "scene/daylight.h"
#include "scene/facing.h"
#include "scene/obj/obj_reader.h"
#include "scene/partitions.h"
#include "scene/tessellation.h"

#include <algorithm>
#include <array>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

namespace multipath {

namespace {

namespace fs = std::filesystem;

constexpr std::array<NamedValue<double>, 5> unit_choices = {
    {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"ft", 0.3048}}}; // [m]

constexpr std::array<NamedValue<bool>, 2> light_choices = {{{"watt", false}, {"lux", true}}};

/// The options of the remedies, in the order of Remedy.
constexpr std::array<std::string_view, 7> remedy_options = {"patch-size", "two-sided",        "flip", "lamp", "sky",
                                                            "sun",        "reflectance-limit"};

} // namespace

OptionGroup scene_option_group()
{
    return {
        "Scene",
        {{"patch-size", 'p', "SIZE", "", "Longest edge of a patch in metres; see 'help scenes' for the default."},
         {"patches", 0, "N", "", "Largest number of patches, at least one for each surface; instead of --patch-size."},
         {"two-sided", 0, "", "", "Give every surface patches on its back too. Only fronts emit."},
         {"flip", 0, "", "", "Turn every face over, for a scene modelled to be seen from outside; see 'help scenes'."},
         {"unit", 0, "UNIT", "m", "Unit of the coordinates in the file; all options and results are in metres.", false,
          names_of(unit_choices)},
         memory_option(),
         {"lamp", 0, "NAME=E", "",
          "Let a material, or else an object or group, emit E in W/m^2, one number or three for red, green, blue.",
          true},
         {"sky", 0, "E", "", "Uniform light from outside: what sees nothing else receives E in W/m^2, as for --lamp."},
         {"sun", 0, "AZIMUTH,ELEVATION,E", "",
          "Parallel light from degrees clockwise of north (-z, or +y where z is up) and degrees above the horizon. A "
          "surface that faces it receives E in W/m^2, as for --lamp."},
         {"unit-light", 0, "UNIT", "watt", "Unit of emittances and powers: W/m^2 and W, or photometric, lx and lm.",
          false, names_of(light_choices)},
         {"ignore", 0, "NAME", "", "Leave out the faces of a material, or else of an object or group.", true},
         {"reflectance-limit", 0, "X", "1", "Reduce reflectances above X to X, for files whose white is 1 or more."}}};
}

std::string option_text(const Advice& advice)
{
    return option_text(remedy_options.at(static_cast<std::size_t>(advice.remedy)), advice.value);
}

std::string advice_text(const std::vector<Advice>& list)
{
    std::string text;
    for (const Advice& advice : list)
        if (advice.effect.empty())
            text += (text.empty() ? ":" : "") + option_text(advice);
        else
            text += ";" + option_text(advice) + " " + advice.effect;
    return text;
}

namespace {

/// Reads a power per area [W/m^2]: "10", or "10,8,6" for red, green and blue.
Rgb read_power(std::string_view option, const std::string& text)
{
    Vec3 e;
    if (text.find(',') == std::string::npos)
        e.x = e.y = e.z = read_positive(option, text);
    else
        e = read_vec3(option, text);
    if (!(std::min({e.x, e.y, e.z}) >= 0.0 && std::max({e.x, e.y, e.z}) <= 1e30 && e.x + e.y + e.z >= 1e-30))
        throw UsageError(std::string(option) + ": expected powers from 0 to 1e30 W/m^2, one of them above 1e-30, got " +
                         quoted_argument(text));
    return {e.x, e.y, e.z};
}

/// Reads azimuth, elevation and power: "135,45,800" or "135,45,800,780,700".
Sun read_sun(const std::string& text, Vec3 up)
{
    const std::size_t first = text.find(',');
    const std::size_t second = first == std::string::npos ? first : text.find(',', first + 1);
    if (second == std::string::npos)
        throw UsageError("--sun: expected azimuth, elevation and power such as 135,45,800, got " +
                         quoted_argument(text));
    const double azimuth = read_real("--sun, azimuth", text.substr(0, first), -360.0, 360.0);
    const double elevation = read_real("--sun, elevation", text.substr(first + 1, second - first - 1), 0.0, 90.0);
    return sun_at(azimuth, elevation, up, read_power("--sun", text.substr(second + 1)));
}

/// Reads "NAME=10" or "NAME=10,8,6".
ObjChanges::Lamp read_lamp(const std::string& text)
{
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos || equals == 0)
        throw UsageError("--lamp: expected a name and a power per area such as 'ceiling light=10', got " +
                         quoted_argument(text));
    return {text.substr(0, equals), read_power("--lamp", text.substr(equals + 1))};
}

ObjChanges read_changes(const CommandLine& line)
{
    ObjChanges changes;
    for (const std::string& text : line.all("lamp")) {
        const ObjChanges::Lamp lamp = read_lamp(text);
        for (const ObjChanges::Lamp& other : changes.lamps)
            if (other.name == lamp.name)
                throw UsageError("--lamp: " + quoted_argument(lamp.name) +
                                 " is named twice; expected one power for it");
        changes.lamps.push_back(lamp);
    }
    changes.ignored = line.all("ignore");
    changes.lit_from_outside = line.has("sky") || line.has("sun");
    changes.unit = line.choice("unit", unit_choices).value;
    changes.reflectance_limit = read_real("--reflectance-limit", line.text("reflectance-limit"), 0.0, 1.0);
    return changes;
}

/// The scene with the surfaces turned over that look away from its light, and with a warning of it.
Scene turned_to_light(Scene scene, int threads)
{
    const std::vector<std::uint32_t> turned = surfaces_to_turn(scene.file(), scene.intersector(), scene.two_sided());
    if (turned.empty())
        return scene;
    SceneFile file = scene.file();
    for (const std::uint32_t surface : turned)
        turn_over(file, surface);
    file.warnings.push_back(
        file.path + ": surfaces that look away from the light were turned over: " + grouped(turned.size()) +
        " (--flip turns all faces instead" + (scene.two_sided() ? ")" : ", --two-sided gives them backs)"));
    return Scene(std::move(file), scene.patch_size(), scene.two_sided(), threads);
}

} // namespace

std::string scene_path(const CommandLine& line)
{
    std::string name = line.operands()[0];
    std::error_code error;
    if (name.empty() || name.find_first_of(folder_separators) != std::string::npos || fs::exists(path_of(name), error))
        return name;
    const std::string folder = bundled_scenes_folder();
    if (!folder.empty())
        for (const std::string& file : {folder + "/" + name, folder + "/" + name + ".obj"})
            if (fs::is_regular_file(path_of(file), error) && path_of(file).extension() == ".obj")
                return file;
    return name;
}

Scene read_scene(const CommandLine& line, int threads)
{
    if (line.has("patch-size") && line.has("patches"))
        throw UsageError("--patches and --patch-size exclude each other; expected one of them");
    // Checked before the file is read, which may take long.
    const double given_size = line.has("patch-size") ? read_positive("--patch-size", line.text("patch-size")) : 0.0;
    const std::uint64_t wanted =
        line.has("patches") ? read_count("--patches", line.text("patches"), 1, (1ull << 31) - 1) : 0;

    const ObjChanges changes = read_changes(line);
    const Rgb sky = line.has("sky") ? read_power("--sky", line.text("sky")) : Rgb{};
    std::optional<Sun> sun;
    if (line.has("sun"))
        sun = read_sun(line.text("sun"),
                       line.knows("up") ? read_direction("--up", line.text("up")) : Vec3{0.0, 1.0, 0.0});
    const std::string path = scene_path(line);
    require_memory_for_file(line, path);
    SceneFile file = read_obj(path, changes);
    if (line.has("flip"))
        file = flipped(std::move(file));
    constexpr bool either_side = true; // which way surfaces face is decided when their light is known
    if (const PartitionCuts cuts = cut_at_partitions(file, either_side); cuts.surfaces > 0 || !cuts.complete)
        file.counts += "; " + counted(cuts.surfaces, "surface") + " cut into " + grouped(cuts.pieces) +
                       " where partitions stand" + (cuts.complete ? "" : ", too many to cut all");
    const double sides = line.has("two-sided") ? 2.0 : 1.0;
    const auto surfaces = static_cast<double>(file.surfaces.size());
    const auto adaptive = static_cast<double>(adaptive_patches(line, file.surfaces)) / sides;
    double cells = static_cast<double>(wanted) / sides; // 0: by a patch size
    if (wanted == 0 && adaptive > 0.0) // refinement begins with a third of the patches that are not whole surfaces
        cells = std::max(surfaces, surfaces + (adaptive - surfaces) / 3.0);
    const auto cell_limit = static_cast<std::uint64_t>(std::max(1.0, cells));
    const double patch_size = given_size > 0.0 ? given_size
                              : cells > 0.0    ? patch_size_for_count(file.surfaces, cell_limit)
                                               : default_patch_size(file.surfaces);
    file.sun = sun;
    file.photometric = line.choice("unit-light", light_choices).value;
    if (line.has("sky"))
        add_sky(file, sky);
    require_memory_for_patches(line, file, sides * cell_count(file, patch_size));
    Scene scene(std::move(file), patch_size, line.has("two-sided"), threads);
    if (!line.has("flip"))
        scene = turned_to_light(std::move(scene), threads);
    if (!(mean(scene.source_power()) > 0.0))
        throw InputError(path +
                         ": no light reaches any surface: the sun shines on no front; --two-sided gives them backs");
    return scene;
}

std::uint64_t adaptive_patches(const CommandLine& line, const SurfaceList& surfaces)
{
    if (!line.knows("adaptive"))
        return 0;
    if (line.has("adaptive"))
        return read_count("--adaptive", line.text("adaptive"), 1, (1ull << 31) - 1);
    constexpr std::uint64_t usual = 5000;
    constexpr std::size_t finely_modelled = 1000000; // such surfaces are small enough, and refinement would take long
    if (line.has("patches") || line.has("patch-size") || surfaces.size() > finely_modelled)
        return 0;
    return (line.has("two-sided") ? 2 : 1) * (usual + surfaces.size() + surfaces.size() / 4);
}

Option threads_option()
{
    return {"threads", 't', "N", "",
            "Number of threads, on which the result does not depend. By default as many as processors."};
}

int thread_count(const CommandLine& line)
{
    if (line.has("threads"))
        return static_cast<int>(read_count("--threads", line.text("threads"), 1, 1024));
    return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

std::string bundled_scenes_folder()
{
    std::error_code error;
    const fs::path program = path_of(program_path());
    if (!program.has_parent_path())
        return "";
    const fs::path folder = program.parent_path();
    for (const fs::path& scenes : {folder.parent_path() / "share" / "multipath" / "scenes", folder / "scenes"})
        if (fs::is_directory(scenes, error))
            return scenes.u8string();
    return "";
}

} // namespace multipath
