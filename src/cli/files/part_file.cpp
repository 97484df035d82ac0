// A part file is locked while the program that made it runs. A part file that is not locked is abandoned and may be
// removed. This works however a run ends, even by SIGKILL, which runs no destructors. O_TMPFILE (a file without a name
// until it is complete) does not work on every file system; and with names users can see the space that a killed run
// has taken.

#include "cli/files/part_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace multipath {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t letter_count = 6;
constexpr std::string_view ending = ".part";

/// Six letters that differ between processes, files and attempts; O_EXCL guarantees that the name is new.
std::string letters(unsigned attempt)
{
    const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
    auto bits =
        (static_cast<std::uint64_t>(now) + attempt) * 0x9E3779B97F4A7C15u ^ static_cast<std::uint64_t>(getpid());
    std::string result;
    for (std::size_t i = 0; i < letter_count; ++i, bits /= 26)
        result += static_cast<char>('a' + bits % 26);
    return result;
}

/// Prefix of the names of all part files of a target.
std::string name_start(const std::string& target)
{
    // 200 bytes leave room for the rest below the usual limit of 255.
    return "." + target.substr(folder_of(target).size(), 200) + ".";
}

bool is_part_name(const std::string& name, const std::string& start)
{
    return name.size() == start.size() + letter_count + ending.size() && name.compare(0, start.size(), start) == 0 &&
           name.compare(start.size() + letter_count, ending.size(), ending) == 0 &&
           name.find_first_not_of("abcdefghijklmnopqrstuvwxyz", start.size()) == start.size() + letter_count;
}

void remove_if_abandoned(const std::string& path)
{
    const int file = open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0)
        return;
    if (flock(file, LOCK_EX | LOCK_NB) == 0)
        unlink(path.c_str());
    close(file);
}

void remove_abandoned(const std::string& target)
{
    const std::string folder = folder_of(target);
    const std::string start = name_start(target);
    std::error_code error;
    fs::directory_iterator entry(folder.empty() ? "." : folder, error);
    for (const fs::directory_iterator end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (is_part_name(name, start))
            remove_if_abandoned(folder + name);
    }
}

/// Locks a new file. False if another run has locked or removed it in between, as abandoned. True also on file systems
/// without locks, where no other run can lock it either.
bool locked(const PartFile& file)
{
    if (flock(file.descriptor, LOCK_EX | LOCK_NB) != 0)
        return errno != EWOULDBLOCK;
    struct stat status = {};
    return fstat(file.descriptor, &status) == 0 && status.st_nlink > 0;
}

} // namespace

std::string folder_of(const std::string& path)
{
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "" : path.substr(0, slash + 1);
}

PartFile create_part_file(const std::string& target, mode_t mode)
{
    remove_abandoned(target);
    PartFile file;
    for (unsigned attempt = 0; attempt < 100; ++attempt) {
        file.path = folder_of(target) + name_start(target) + letters(attempt) + std::string(ending);
        file.descriptor = open(file.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        if (file.descriptor < 0 && errno != EEXIST)
            return file;
        if (file.descriptor >= 0 && locked(file))
            return file;
        if (file.descriptor >= 0)
            close(file.descriptor);
    }
    return {file.path, -1};
}

namespace {

// A signal handler may neither wait for a lock nor use the heap, which another thread may be changing at that moment.
// So the names are kept in slots of a fixed size, each with an atomic state.

enum class State { empty, changing, full, complete };

struct Slot
{
    std::atomic<State> state{State::empty};
    std::array<char, 4096> path{}; ///< no system opens longer ones
    std::array<char, 4096> target{};
};

std::array<Slot, 64> slots;
static_assert(std::atomic<State>::is_always_lock_free, "a signal handler reads it");

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
