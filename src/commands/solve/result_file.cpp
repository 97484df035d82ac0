#include "commands/solve/result_file.h"

#include "cli/provenance.h"
#include "commands/commands.h"
#include "commands/solve/saved_run.h"

namespace multipath {

namespace {

PatchTable table_of(const std::string& path, const SavedRun& saved, const Scene& scene)
{
    const Solution solution = finished_solution(saved, scene);
    PatchTable table;
    table.path = path;
    table.comments = provenance(solve_command().table, command_line_of(saved.description, {}), scene);
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        table.surfaces.push_back(scene.surface_of(i));
        table.materials.push_back(scene.material_of(i).name);
        table.centres.push_back(scene.patch(i).shape.centre());
    }
    table.areas = scene.weights();
    table.radiosity = solution.radiosity;
    table.standard_error = solution.standard_error;
    return table;
}

} // namespace

ResultFile::ResultFile(const std::string& path, const PatchTable* beside)
{
    if (!is_state_file(path)) {
        table = read_patch_table(path, beside);
        return;
    }
    const SavedRun saved = read_saved_run(path);
    scene = std::make_unique<const Scene>(restored(saved.description.scene));
    table = table_of(path, saved, *scene);
}

bool have_same_surfaces(const Scene& a, const Scene& b)
{
    return a.two_sided() == b.two_sided() && a.surfaces() == b.surfaces();
}

} // namespace multipath
