// A handler of signals may neither wait for a lock nor touch the heap, which another thread may be changing at that
// moment. So the names stand in slots of a fixed size, each with a state that changes in one step.

#include "cli/files/unfinished.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <cstring>
#include <unistd.h>
#include <utility>

namespace multipath {

namespace {

enum class State { empty, changing, full, complete };

struct Slot
{
    std::atomic<State> state{State::empty};
    std::array<char, 4096> path{}; ///< longer ones no system opens
    std::array<char, 4096> target{};
};

std::array<Slot, 64> slots;
static_assert(std::atomic<State>::is_always_lock_free, "a handler of signals reads it");

} // namespace

Unfinished::Unfinished(const std::string& path, const std::string& target)
{
    const std::size_t longest = std::max(path.size(), target.size());
    for (std::size_t n = 0; n < slots.size() && longest < slots[n].path.size(); ++n) {
        State expected = State::empty;
        if (!slots[n].state.compare_exchange_strong(expected, State::changing))
            continue;
        std::memcpy(slots[n].path.data(), path.c_str(), path.size() + 1);
        std::memcpy(slots[n].target.data(), target.c_str(), target.size() + 1);
        slots[n].state = State::full;
        slot_ = static_cast<int>(n);
        return;
    }
}

Unfinished::Unfinished(Unfinished&& other) noexcept : slot_(std::exchange(other.slot_, none)) {}

Unfinished& Unfinished::operator=(Unfinished&& other) noexcept
{
    forget();
    slot_ = std::exchange(other.slot_, none);
    return *this;
}

void Unfinished::complete() noexcept
{
    if (slot_ != none)
        slots[static_cast<std::size_t>(slot_)].state = State::complete;
}

void Unfinished::forget() noexcept
{
    if (slot_ != none)
        slots[static_cast<std::size_t>(std::exchange(slot_, none))].state = State::empty;
}

void remove_unfinished() noexcept
{
    for (const Slot& slot : slots)
        if (slot.state == State::full || slot.state == State::complete)
            unlink(slot.path.data());
}

void settle_unfinished(void (*not_written)(const char* target)) noexcept
{
    for (const Slot& slot : slots) {
        const State state = slot.state;
        if (state == State::complete && std::rename(slot.path.data(), slot.target.data()) == 0)
            continue;
        if (state == State::full || state == State::complete)
            not_written(slot.target.data());
    }
    remove_unfinished();
}

} // namespace multipath
