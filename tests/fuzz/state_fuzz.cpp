// Any arrays as the state of a run, under a checksum that is right: a run with a scene and its solution, or an error.

#include "base/errors.h"
#include "commands/solve/saved_run.h"

#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

using namespace multipath;

namespace {

/// A state file with these bytes between its header and its end.
class MadeUpState : public StateWriter
{
public:
    MadeUpState(const Sink& sink, std::string_view arrays) : StateWriter(sink)
    {
        put(arrays);
        finish();
    }
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    std::string bytes;
    const MadeUpState state([&](std::string_view more) { bytes += more; }, {reinterpret_cast<const char*>(data), size});
    try {
        const SavedRun saved = read_saved_run(std::make_unique<StateReader>("made up", bytes));
        if (saved.description.scene.patches > 10000)
            return 0;
        const Scene scene = restored(saved.description.scene);
        if (finished_solution(saved, scene).radiosity.size() != scene.patch_count())
            std::abort();
    } catch (const ArchiveError&) {
    } catch (const InputError&) {
    }
    return 0;
}
