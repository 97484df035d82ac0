#pragma once

#include "parallel/archive.h"

#include <functional>
#include <string>
#include <vector>

namespace multipath {

/// Interrupts long work and resumes it later, with the same bits as without interruption.
///
/// Work consists of nested parts. Each part can save its state: its results so far and its progress. A pause saves all
/// active parts together. To resume, the program simply starts the work again from the beginning: every part that was
/// active at the pause reads its saved state and skips what is done.
class Checkpoint
{
public:
    /// Saves or restores the state of a part.
    using Visit = std::function<void(Archive& archive)>;

    /// Part of the work, active from construction to destruction. The constructor restores a saved state, if there is
    /// one, and throws ArchiveError if it does not fit.
    class Part
    {
    public:
        Part(Checkpoint* checkpoint, std::string name, Visit visit); ///< does nothing if null
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

    /// True if pause() should be called soon. Called often, from any thread.
    virtual bool wants_pause() const = 0;

    /// Pauses the work; call it only when the state of every part is consistent. Returns true if the work must end here
    /// with the results it has.
    bool pause() { return stopped_ = stopped_ || pause_now(); }
    bool stopped() const { return stopped_; }

    /// Ends the run of a shard that is done: saves its results, which `merge` adds to those of the other shards.
    void publish_shard()
    {
        publish_shard_now();
        stopped_ = true;
    }

    /// Ends complete work: the active parts hold its final state.
    void finish() { finish_now(); }

    /// Names of the active parts, outermost first.
    std::vector<std::string> parts() const;

protected:
    virtual bool pause_now() = 0;
    virtual void publish_shard_now() = 0;
    virtual void finish_now() = 0;

    /// Writes the state of all active parts.
    void save(Archive& archive) const;
    /// The parts constructed next must have these names, each nested in the one before, and restore their states from
    /// the archive, which must live that long.
    void resume_from(Archive& archive, std::vector<std::string> parts);

private:
    std::vector<const Part*> under_way_;
    std::vector<std::string> expected_; ///< names of the parts to be restored; empty when all are
    Archive* saved_ = nullptr;          ///< where expected parts restore their states from
    bool stopped_ = false;
};

} // namespace multipath
