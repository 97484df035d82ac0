#include "commands/state_keeper.h"

#include "cli/interrupt.h"
#include "cli/output_file.h"

#include <utility>

namespace multipath {

StateKeeper::StateKeeper(StatePlan plan, RunDescription description)
    : plan_(std::move(plan)),
      description_(std::move(description)),
      next_save_(Clock::now() +
                 std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(plan_.save_every)))
{
}

void StateKeeper::resume(SavedRun saved)
{
    resumed_ = std::move(saved);
    resume_from(*resumed_->arrays, resumed_->parts);
}

bool StateKeeper::wants_pause() const
{
    worked_ = true;
    return interrupted() || (!plan_.path.empty() && Clock::now() >= next_save_);
}

void StateKeeper::write(const StateWriter::Sink& sink)
{
    std::vector<std::string> names = parts();
    StateWriter writer(sink);
    visit_head(writer, description_, names);
    save(writer);
    writer.finish();
}

void StateKeeper::keep_in_memory()
{
    last_bytes_.clear();
    write([&](std::string_view bytes) { last_bytes_ += bytes; });
}

void StateKeeper::keep()
{
    if (!plan_.path.empty()) {
        OutputFile file(plan_.path);
        const InterruptDelay delay;
        write([&](std::string_view bytes) { file.write(bytes); });
        file.commit();
    }
    if (plan_.keep_last)
        keep_in_memory();
}

bool StateKeeper::pause_now()
{
    const Clock::time_point start = Clock::now();
    keep();
    const auto interval = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(plan_.save_every));
    // A large state is saved less often, so that saving stays a small part of the time.
    next_save_ = Clock::now() + std::max(interval, 10 * (Clock::now() - start));
    return interrupted();
}

void StateKeeper::hand_in_now()
{
    keep();
    handed_in_ = true;
}

void StateKeeper::finish_now()
{
    if (!resumed_ || worked_)
        keep();
    else if (plan_.keep_last) // the file says it already
        keep_in_memory();
}

} // namespace multipath
