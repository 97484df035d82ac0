#pragma once

#include "base/archive.h"

#include <cstdint>
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

    /// Ends the run of a shard (see Shard) that is done: saves the results of the active parts, which the
    /// command `merge` adds to those of the other shards.
    void publish_shard()
    {
        publish_shard_now();
        stopped_ = true;
    }

    /// Reports that the work is complete. Call it while the parts that hold the final state are still active.
    virtual void finish() = 0;

    /// Names of the active parts, outermost first.
    std::vector<std::string> parts() const;

protected:
    // What pause() and publish_shard() do in a derived class. pause_now() returns true to stop the work.
    virtual bool pause_now() = 0;
    virtual void publish_shard_now() = 0;

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

/// One shard, that is, one part of work that is split over several runs, usually on several computers.
struct Shard
{
    std::uint64_t number = 0; ///< index of this shard, 0 ... of - 1
    std::uint64_t of = 1;     ///< number of shards

    /// This shard does begin(units) ... end(units) - 1 of the units 0 ... units - 1, such as blocks of lines. All
    /// shards together do each unit once.
    std::uint64_t begin(std::uint64_t units) const { return before(number, units); }
    std::uint64_t end(std::uint64_t units) const { return before(number + 1, units); }

private:
    /// units * n / of without overflow.
    std::uint64_t before(std::uint64_t n, std::uint64_t units) const { return units / of * n + units % of * n / of; }
};

/// Settings of how work is carried out. The result does not depend on them, except that a shard does only its part.
struct RunControl
{
    int threads = 1;
    /// Progress callback, called now and then with the number of lines done since the last call: from any thread, but
    /// never from two at once. Empty: progress is not reported.
    std::function<void(std::uint64_t lines)> line_counter{};
    Checkpoint* checkpoint = nullptr; ///< null: the work runs without pauses
    Shard shard{};                    ///< for stages whose results can be added; several shards need a checkpoint

    void count_lines(std::uint64_t lines) const
    {
        if (line_counter)
            line_counter(lines);
    }
    /// True if the checkpoint has stopped the work.
    bool stopped() const { return checkpoint && checkpoint->stopped(); }
    /// True if the work is split over several shards.
    bool is_shard() const { return shard.of > 1; }
};

} // namespace multipath
