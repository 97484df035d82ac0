#include "commands/result_table.h"

#include "cli/provenance.h"
#include "commands/saved_run.h"
#include "commands/solve_table.h"

namespace multipath {

PatchTable read_result(const std::string& path)
{
    if (!is_state_file(path))
        return read_patch_table(path);
    const SavedRun saved = read_saved_run(path);
    const Scene scene = restored(saved.description.scene);
    const Solution solution = finished_solution(saved, scene);
    PatchTable table;
    table.path = path;
    table.comments = provenance(solve_table(), command_line_of(saved.description, {}), scene);
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        table.surfaces.push_back(scene.surface_of(i));
        table.materials.push_back(scene.material_of(i).name);
        table.centres.push_back(scene.patch(i).shape.centre());
    }
    table.areas = scene.areas();
    table.radiosity = solution.radiosity;
    table.standard_error = solution.standard_error;
    return table;
}

} // namespace multipath
