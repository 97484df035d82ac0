#pragma once

#include "parallel/archive.h"

#include <functional>
#include <string>
#include <vector>

namespace multipath {

/// Interrupts long work and resumes it later; the results have the same bits as without interruption.
///
/// Work consists of nested parts. Each part can save its state, which consists of its results so far and its progress.
/// A pause saves the states of all active parts together. To resume, the program simply starts the work again from the
/// beginning: every part that was active at the pause reads its saved state and skips what is done.
class Checkpoint
{
public:
    /// Function that writes the state of a part to an archive, or reads it, if archive.reads().
    using Visit = std::function<void(Archive& archive)>;

    /// Part of the work, active from construction to destruction. Parts must be destroyed in the reverse order of their
    /// construction.
    class Part
    {
    public:
        /// Restores the saved state of the part, if there is one, by calling `visit`. Throws ArchiveError if the saved
        /// state is that of a part with another name or does not fit. The part has no effect if `checkpoint` is null.
        Part(Checkpoint* checkpoint, std::string name, Visit visit);
        ~Part();
        Part(const Part&) = delete;
        Part& operator=(const Part&) = delete;

        bool resumed() const { return resumed_; } ///< true if a saved state was read

    private:
        friend class Checkpoint;

        void visit_part(Archive& archive) const;

        Checkpoint* checkpoint_;
        std::string name_;
        Visit visit_;
        bool resumed_ = false;
    };

    virtual ~Checkpoint() = default;

    /// True if pause() should be called soon. May be called often and from any thread.
    virtual bool wants_pause() const = 0;

    /// Saves the states of all active parts, which must be consistent. Returns true if the work must end here, with the
    /// results it has so far; later calls then return true without saving.
    bool pause() { return stopped_ = stopped_ || pause_now(); }
    /// True if pause() has returned true or publish_shard() was called: the work must end.
    bool stopped() const { return stopped_; }

    /// Ends the run of a shard (see run_control.h) that is done: saves the results of the active parts, which the
    /// command `merge` adds to those of the other shards.
    void publish_shard()
    {
        publish_shard_now();
        stopped_ = true;
    }

    /// Reports that the work is complete. Call it while the parts that hold the final state are still active.
    void finish() { finish_now(); }

    /// Names of the active parts, outermost first.
    std::vector<std::string> parts() const;

protected:
    // What pause(), publish_shard() and finish() do in a derived class. pause_now() returns true to stop the work.
    virtual bool pause_now() = 0;
    virtual void publish_shard_now() = 0;
    virtual void finish_now() = 0;

    /// Writes the state of all active parts.
    void save(Archive& archive) const;
    /// Makes the parts that are constructed next restore their states from the archive, which must exist until the last
    /// of them has done so. `parts`: the names of these parts, outermost first, each nested in the one before.
    void resume_from(Archive& archive, std::vector<std::string> parts);

private:
    std::vector<const Part*> under_way_; ///< the active parts, outermost first
    std::vector<std::string> expected_;  ///< names of the parts to be restored; empty once all have been
    Archive* saved_ = nullptr;           ///< contains the states of the expected parts
    bool stopped_ = false;
};

} // namespace multipath
