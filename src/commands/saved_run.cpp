#include "commands/saved_run.h"

#include "radiosity/solution.h"
#include "scene/input_error.h"

#include <utility>

namespace multipath {

void visit_head(Archive& archive, RunDescription& description, std::vector<std::string>& parts)
{
    description.visit(archive);
    archive.texts("parts", parts);
}

SavedRun read_saved_run(std::unique_ptr<StateReader> arrays)
{
    SavedRun saved;
    visit_head(*arrays, saved.description, saved.parts);
    saved.arrays = std::move(arrays);
    return saved;
}

SavedRun read_saved_run(const std::string& path)
{
    return read_saved_run(std::make_unique<StateReader>(path));
}

bool is_finished(const SavedRun& saved)
{
    return saved.parts == std::vector<std::string>{RunRecord::part};
}

Solution finished_solution(const SavedRun& saved, const Scene& scene)
{
    RunRecord record;
    const Archive::Inner inner(*saved.arrays, RunRecord::part);
    record.visit(*saved.arrays, scene.patch_count());
    if (record.pieces == 0)
        throw InputError(saved.name() + ": the run is not finished; expected 'multipath solve --state " + saved.name() +
                         " --resume' first");
    return std::move(record.solution);
}

} // namespace multipath
