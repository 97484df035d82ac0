// A handler of signals may neither wait for a lock nor touch the heap, which another thread may be changing at that
// moment. So the names stand in slots of a fixed size, each with a state that changes in one step.

#include "cli/unfinished.h"

#include <array>
#include <atomic>
#include <cstring>
#include <unistd.h>
#include <utility>

namespace multipath {

namespace {

enum class State { empty, changing, full };

struct Slot
{
    std::atomic<State> state{State::empty};
    std::array<char, 4096> path{}; ///< longer ones no system opens
};

std::array<Slot, 64> slots;
static_assert(std::atomic<State>::is_always_lock_free, "a handler of signals reads it");

} // namespace

Unfinished::Unfinished(const std::string& path)
{
    for (std::size_t n = 0; n < slots.size() && path.size() < slots[n].path.size(); ++n) {
        State expected = State::empty;
        if (!slots[n].state.compare_exchange_strong(expected, State::changing))
            continue;
        std::memcpy(slots[n].path.data(), path.c_str(), path.size() + 1);
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

void Unfinished::forget() noexcept
{
    if (slot_ != none)
        slots[static_cast<std::size_t>(std::exchange(slot_, none))].state = State::empty;
}

void remove_unfinished() noexcept
{
    for (const auto& remove : {unlink, rmdir}) // a folder is empty only without its files
        for (const Slot& slot : slots)
            if (slot.state == State::full)
                remove(slot.path.data());
}

} // namespace multipath
