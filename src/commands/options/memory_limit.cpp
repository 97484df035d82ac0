#include "commands/options/memory_limit.h"

#include "base/errors.h"
#include "base/file_bytes.h"
#include "base/platform/machine.h"
#include "base/text_format.h"
#include "cli/options/number_text.h"
#include "radiosity/reuse/balanced_reuse.h"
#include "radiosity/reuse/line_reuse.h"
#include "radiosity/run/memory_estimate.h"

#include <algorithm>
#include <system_error>

namespace multipath {

namespace {

double memory_limit(const CommandLine& line)
{
    return line.has("memory") ? static_cast<double>(read_bytes("--memory", line.text("memory"))) : machine_memory();
}

/// "400 GB"
std::string size_text(double bytes)
{
    return bytes < 1e9 ? format("%.3g MB", bytes / 1e6) : format("%.3g GB", bytes / 1e9);
}

/// Throws InputError "WHAT about SIZE of memory, but ...; expected EXPECTED" if the bytes exceed the limit.
void require(const CommandLine& line, double bytes, const std::string& what, const std::string& expected)
{
    const double limit = memory_limit(line);
    if (bytes > limit)
        throw InputError(what + " about " + size_text(bytes) + " of memory, but " +
                         (line.has("memory") ? "--memory allows " : "this machine has ") + size_text(limit) +
                         "; expected " + expected);
}

} // namespace

Option memory_option()
{
    return {
        "memory", 0, "SIZE", "",
        "Memory limit, such as 8GB: a run that needs more is refused. By default the memory of the machine, and 2GB "
        "for the table of patch pairs of reuse."};
}

void require_memory_for_file(const CommandLine& line, const std::string& path)
{
    std::error_code error;
    const auto size = std::filesystem::file_size(path_of(path), error); // fails for pipes
    if (!error)
        require(line, static_cast<double>(size), path + ": reading it needs", "a smaller file");
}

void require_memory_for_patches(const CommandLine& line, const SceneFile& file, double patches)
{
    const auto surfaces = static_cast<double>(file.surfaces.size());
    const double counted = std::min(patches, 1e15); // `patches` may be infinite
    require(line, run_bytes(surfaces, counted),
            file.path + ": " + grouped(static_cast<std::uint64_t>(counted)) +
                (patches > counted ? " patches and more" : " patches") + " need",
            patches > 2.0 * surfaces ? "fewer patches: a larger --patch-size" : "a smaller scene");
}

void require_memory_for_page(const CommandLine& line, const Scene& scene)
{
    require(line, page_bytes(static_cast<double>(scene.surfaces().size()), scene.patch_count()),
            scene.path() + ": a page of " + grouped(scene.patch_count()) + " patches needs",
            "fewer patches, or no .html");
}

void require_memory_for_picture(const CommandLine& line, int width, int height, bool gathers)
{
    // The picture as light, as colours and as a file; gathering also stores data for every pixel.
    const double bytes_per_pixel = gathers ? 220.0 : 40.0;
    require(line, bytes_per_pixel * width * height, format("--size: a picture of %d x %d pixels needs", width, height),
            "a smaller one");
}

void require_memory_for_reuse(const CommandLine& line, const SolveOptions& options, const Scene& scene)
{
    if (options.method != Method::reuse || options.lines < min_balanced_rays(scene))
        return;
    const double with_table =
        run_bytes(static_cast<double>(scene.surfaces().size()), scene.patch_count()) + reuse_bytes(scene);
    require(line, std::min(with_table, min_balanced_bytes(scene)),
            scene.path() + ": line reuse of " + grouped(scene.patch_count()) + " patches needs",
            "fewer patches: a larger --patch-size, or --method local");
}

int reuse_runs_at_a_time(const CommandLine& line, const Scene& scene, int threads)
{
    const double of_pairs = line.has("memory") ? memory_limit(line) : SolveOptions{}.memory;
    const double runs = memory_limit(line) / std::min(of_pairs, reuse_bytes(scene));
    return static_cast<int>(std::clamp(runs, 1.0, static_cast<double>(threads)));
}

} // namespace multipath
