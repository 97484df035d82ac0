#pragma once

#include "parallel/archive.h"

#include <functional>
#include <string>
#include <vector>

namespace multipath {

/// Where long work can be left and taken up again, with the same bits as if it had never been left.
///
/// Work consists of parts within parts. Each says what it needs to go on from here: what it has found so far and how
/// far it is. All that is under way at a pause is saved together. To take work up again it is simply begun again: every
/// part that was under way finds what was saved, and skips what is done.
class Checkpoint
{
public:
    /// Writes or reads what a part has.
    using Visit = std::function<void(Archive& archive)>;

    /// A part of the work, from construction to destruction. Throws ArchiveError where what is saved does not fit.
    class Part
    {
    public:
        Part(Checkpoint* checkpoint, std::string name, Visit visit); ///< without a checkpoint, nothing happens
        ~Part();
        Part(const Part&) = delete;
        Part& operator=(const Part&) = delete;

        bool resumed() const { return resumed_; } ///< has it read what was saved?

    private:
        friend class Checkpoint;

        void visit_part(Archive& archive) const;

        Checkpoint* checkpoint_;
        std::string name_;
        Visit visit_;
        bool resumed_ = false;
    };

    virtual ~Checkpoint() = default;

    /// Is there something to do at a pause? Asked by any thread, often.
    virtual bool wants_pause() const = 0;

    /// At a moment when every part is whole. True: the work is to end here, with what it has.
    bool pause() { return stopped_ = stopped_ || pause_now(); }
    bool stopped() const { return stopped_; }

    /// The share of this run is done: what it has found is saved for those who add it to that of others, and it ends.
    void hand_in()
    {
        hand_in_now();
        stopped_ = true;
    }

    /// All is done: what the parts hold now is the end.
    void finish() { finish_now(); }

    /// The names of the parts under way, the outermost first.
    std::vector<std::string> parts() const;

protected:
    virtual bool pause_now() = 0;
    virtual void hand_in_now() = 0;
    virtual void finish_now() = 0;

    void save(Archive& archive) const;
    /// From now on the parts of these names, each within the one before, read what was saved of them.
    void resume_from(Archive& archive, std::vector<std::string> parts);

private:
    std::vector<const Part*> under_way_;
    std::vector<std::string> expected_; ///< parts that are to read what was saved
    Archive* saved_ = nullptr;
    bool stopped_ = false;
};

} // namespace multipath
