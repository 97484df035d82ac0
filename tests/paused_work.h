#pragma once

#include "export/state_file.h"
#include "parallel/run_control.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace multipath {

/// Work that was left: what a checkpoint keeps of it.
struct SavedWork
{
    std::string bytes;
    std::vector<std::string> parts;
};

/// Saves at the first pauses, then ends the work; may take up work that was left.
class TestCheckpoint : public Checkpoint
{
public:
    /// Ends the work at pause number `last` (from 0) at a block, or never.
    explicit TestCheckpoint(int last) : last_(last) {}
    TestCheckpoint(int last, const SavedWork& left) : last_(last)
    {
        reader_ = std::make_unique<StateReader>("test", left.bytes);
        resume_from(*reader_, left.parts);
    }

    bool wants_pause() const override { return last_ >= 0; }
    void finish() override
    {
        keep();
        finished_ = true;
    }
    int pauses() const { return pauses_; }
    const SavedWork& saved() const { return saved_; }
    bool finished() const { return finished_; }

private:
    bool pause_now() override
    {
        if (pauses_++ < last_)
            return false;
        keep();
        return true;
    }
    void publish_shard_now() override { keep(); }
    void keep()
    {
        saved_ = {"", parts()};
        StateWriter writer([this](std::string_view bytes) { saved_.bytes += bytes; });
        save(writer);
        writer.finish();
    }

    int last_;
    int pauses_ = 0;
    bool finished_ = false;
    SavedWork saved_;
    std::unique_ptr<StateReader> reader_;
};

} // namespace multipath
