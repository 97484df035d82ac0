// The active parts of a Checkpoint form a stack. While a saved run resumes, the part at depth d of the stack must have
// the name at position d of expected_; it then reads its state. Once the innermost expected part has read its state,
// later parts start from the beginning.

#include "parallel/run_control.h"

#include "base/errors.h"
#include "base/lists.h"

#include <utility>

namespace multipath {

Checkpoint::Part::Part(Checkpoint* checkpoint, std::string name, Visit visit)
    : checkpoint_(checkpoint), name_(std::move(name)), visit_(std::move(visit))
{
    if (!checkpoint_)
        return;
    const std::size_t depth = checkpoint_->under_way_.size();
    const std::vector<std::string>& expected = checkpoint_->expected_;
    if (depth < expected.size()) {
        if (expected[depth] != name_)
            throw ArchiveError("the state is of other work: expected " + name_ + ", found " + expected[depth]);
        visit_part(*checkpoint_->saved_);
        resumed_ = true;
        if (depth + 1 == expected.size())
            checkpoint_->expected_.clear();
    }
    checkpoint_->under_way_.push_back(this);
}

Checkpoint::Part::~Part()
{
    if (checkpoint_)
        checkpoint_->under_way_.pop_back();
}

void Checkpoint::Part::visit_part(Archive& archive) const
{
    const Archive::Inner inner(archive, name_);
    visit_(archive);
}

std::vector<std::string> Checkpoint::parts() const
{
    return mapped(under_way_, &Part::name_);
}

void Checkpoint::save(Archive& archive) const
{
    for (const Part* part : under_way_)
        part->visit_part(archive);
}

void Checkpoint::resume_from(Archive& archive, std::vector<std::string> parts)
{
    saved_ = &archive;
    expected_ = std::move(parts);
}

} // namespace multipath
