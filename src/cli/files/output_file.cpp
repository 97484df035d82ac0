#include "cli/files/output_file.h"

#include "base/errors.h"
#include "base/platform/files.h"
#include "cli/options/choices.h"
#include "scene/text/text_words.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>
#include <string_view>
#include <system_error>
#include <utility>

namespace multipath {

// A part file is locked while the program that made it runs. A part file that is not locked is abandoned and may be
// removed. This works however a run ends, even by SIGKILL, which runs no destructors. O_TMPFILE (a file without a name
// until it is complete) does not work on every file system; and with names users can see the space that a killed run
// has taken.

namespace {

namespace fs = std::filesystem;

constexpr std::size_t letter_count = 6;
constexpr std::string_view ending = ".part";

/// Six letters that differ between processes, files and attempts; create_locked_file() guarantees a new name.
std::string letters(unsigned attempt)
{
    static const std::uint64_t process = std::random_device{}();
    const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
    auto bits = (static_cast<std::uint64_t>(now) + attempt) * 0x9E3779B97F4A7C15u ^ process;
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

void remove_abandoned(const std::string& target)
{
    const std::string folder = folder_of(target);
    const std::string start = name_start(target);
    std::error_code error;
    fs::directory_iterator entry(folder.empty() ? "." : folder, error);
    for (const fs::directory_iterator end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (is_part_name(name, start))
            remove_if_unlocked(folder + name);
    }
}

} // namespace

std::string folder_of(const std::string& path)
{
    return path.substr(0, path.find_last_of(folder_separators) + 1); // npos + 1 is 0
}

PartFile create_part_file(const std::string& target, bool is_private)
{
    remove_abandoned(target);
    PartFile file;
    for (unsigned attempt = 0; attempt < 100; ++attempt) {
        file.path = folder_of(target) + name_start(target) + letters(attempt) + std::string(ending);
        file.descriptor = create_locked_file(file.path, is_private);
        if (file.descriptor >= 0 || errno != EEXIST)
            return file;
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
            remove_file(slot.path.data());
}

void settle_unfinished(void (*not_written)(const char* target)) noexcept
{
    for (const Slot& slot : slots) {
        const State state = slot.state;
        if (state == State::complete && rename_over(slot.path.data(), slot.target.data()) == 0)
            continue;
        if (state == State::full || state == State::complete)
            not_written(slot.target.data());
    }
    remove_unfinished();
}

// A result must never be incomplete: not after a full disk, Ctrl-C or a crash. So the bytes go to the temporary file
// ".NAME.XXXXXX.part" in the target's folder, reach the disk (fsync), and get the target's name in one atomic step
// (rename). The temporary file is created before the work, so that a missing or protected folder is reported early.
// Devices, pipes and standard output cannot be renamed and are written directly.

namespace {

const std::string standard_output = "standard output";

[[noreturn]] void fail(const std::string& name, int error)
{
    const std::string message = "cannot write " + name + ": " + std::generic_category().message(error);
    if (error == EPIPE && name == standard_output)
        throw ReaderGone(message);
    throw OutputError(message);
}

/// Resolves the symbolic links at the end of a path, even if the last link points to a file that does not exist yet.
/// Throws OutputError for circular links and chains of 40 links or more.
std::string follow_links(const std::string& name)
{
    std::string path = name;
    for (int links = 0; links < 40; ++links) {
        std::error_code error;
        const fs::path target = fs::read_symlink(path, error);
        if (error)
            return path;
        path = target.is_absolute() ? target.string() : folder_of(path) + target.string();
    }
    fail(name, ELOOP);
}

} // namespace

void make_folder(const std::string& path)
{
    std::error_code error;
    fs::create_directory(path, error);
    std::error_code unknown;
    if (fs::is_directory(path, unknown))
        return;
    const bool failed = error && error != std::errc::file_exists && error != std::errc::not_a_directory;
    throw OutputError(failed ? "cannot make the folder " + path + ": " + error.message()
                             : "cannot write into " + path + ": it is not a folder");
}

OutputFile::OutputFile(const std::string& path) : name_(path == "-" ? standard_output : path)
{
    if (path == "-") {
        descriptor_ = copy_standard_output();
        if (descriptor_ < 0)
            fail(name_, errno);
        return;
    }
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::none)
        fail(name_, error.value());
    if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status)) {
        descriptor_ = open_device(path);
        if (descriptor_ < 0)
            fail(name_, errno);
        return;
    }
    target_ = follow_links(path);
    if (target_.empty())
        fail(name_, ENOENT);
    if (fs::is_directory(status) || folder_of(target_) == target_)
        fail(name_, EISDIR);
    if (const int reason = fs::exists(status) ? check_writable(target_) : 0)
        fail(name_, reason);
    // A private target must not be readable by others before it has the permissions of the old file.
    const PartFile file = create_part_file(target_, fs::exists(status));
    if (file.descriptor < 0)
        fail(name_, errno);
    descriptor_ = file.descriptor;
    temporary_ = file.path;
    unfinished_ = Unfinished(temporary_, target_);
    if (fs::exists(status))
        fs::permissions(temporary_, status.permissions(), error);
    if (error && fs::exists(status)) {
        discard();
        fail(name_, error.value());
    }
}

OutputFile::~OutputFile()
{
    discard();
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : name_(std::move(other.name_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, std::string())),
      unfinished_(std::move(other.unfinished_)),
      descriptor_(std::exchange(other.descriptor_, -1))
{
}

void OutputFile::write(std::string_view bytes)
{
    assert(descriptor_ >= 0);
    discard_at(write_all(descriptor_, bytes));
}

void OutputFile::complete()
{
    assert(descriptor_ >= 0);
    discard_at(finish_writing(descriptor_, !temporary_.empty()));
    unfinished_.complete();
}

void OutputFile::commit()
{
    complete();
    if (!temporary_.empty()) {
        const int error = rename_over(temporary_.c_str(), target_.c_str());
        discard_at(error != 0 ? error : flush_folder(folder_of(target_)));
    }
    temporary_.clear();
    unfinished_ = {};
    close_file(std::exchange(descriptor_, -1)); // after the rename: closing the descriptor releases the lock
}

void OutputFile::discard_at(int error)
{
    if (error == 0)
        return;
    discard();
    fail(name_, error);
}

void OutputFile::discard() noexcept
{
    if (descriptor_ >= 0)
        close_file(std::exchange(descriptor_, -1));
    if (!temporary_.empty())
        remove_file(temporary_.c_str());
    temporary_.clear();
    unfinished_ = {};
}

namespace {

/// True if writing the output would replace the input, or would be found as the input next time: scenes name files
/// regardless of case.
bool takes_place_of(const std::string& output, const std::string& input)
{
    const std::string name = output.substr(folder_of(output).size());
    return same_file(output, input) || (equal_but_for_case(name, input.substr(folder_of(input).size())) &&
                                        same_file(output, folder_of(input) + name));
}

void refuse_input(const std::string& path, const std::vector<std::string>& inputs)
{
    for (const std::string& input : inputs)
        if (takes_place_of(path, input))
            throw UsageError("--output: '" + path + "' is an input; expected another file");
}

std::string lower_case_extension(const std::string& path)
{
    const std::size_t dot = path.find_last_of('.');
    if (dot == std::string::npos || dot < folder_of(path).size())
        return "";
    std::string extension = path.substr(dot);
    for (char& c : extension)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

} // namespace

bool same_file(const std::string& a, const std::string& b)
{
    std::error_code error;
    if (fs::exists(a, error) && fs::exists(b, error))
        return fs::equivalent(a, b, error);
    // Files that do not exist yet: the same name in the same folder.
    const std::string end_a = follow_links(a);
    const std::string end_b = follow_links(b);
    const auto folder = [](const std::string& path) { // Windows knows no folder whose name ends in a separator
        return (fs::path(path).has_root_path() ? "" : "./") + folder_of(path) + ".";
    };
    const auto name = [](const std::string& path) { return path.substr(folder_of(path).size()); };
    return !end_a.empty() && !end_b.empty() &&
           (names_ignore_case ? equal_but_for_case(name(end_a), name(end_b)) : name(end_a) == name(end_b)) &&
           fs::equivalent(folder(end_a), folder(end_b), error);
}

std::string_view output_extension(const std::string& path, const std::vector<std::string_view>& extensions)
{
    if (path == "-")
        return extensions.front();
    const std::string extension = lower_case_extension(path);
    const auto ends_in = [&](std::string_view known) { // "_lightmap.glb" is longer than an extension
        const std::size_t stem = known.size() - extension.size();
        return known.front() == '_' && known.size() > extension.size() && path.size() >= known.size() &&
               known.substr(stem) == extension &&
               path.compare(path.size() - known.size(), stem, known.substr(0, stem)) == 0;
    };
    for (const std::string_view known : extensions)
        if (ends_in(known))
            return known;
    for (const std::string_view known : extensions)
        if (extension == known)
            return known;
    throw UsageError("--output: '" + path + "' does not end in a known extension; expected one of " +
                     listed(extensions) + did_you_mean(extension, {extensions.begin(), extensions.end()}));
}

std::vector<PlannedOutput> open_outputs(const std::vector<std::string>& paths, const std::vector<std::string>& inputs,
                                        const std::vector<std::string_view>& extensions)
{
    std::vector<std::string_view> chosen;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        chosen.push_back(output_extension(paths[i], extensions));
        refuse_input(paths[i], inputs);
        for (std::size_t j = 0; j < i; ++j)
            if (same_file(paths[i], paths[j]))
                throw UsageError("--output: '" + paths[i] + "' is named twice");
    }
    std::vector<PlannedOutput> outputs;
    for (std::size_t i = 0; i < paths.size(); ++i)
        outputs.push_back({chosen[i], OutputFile(paths[i]), 0});
    return outputs;
}

void require_no_input(const std::vector<PlannedOutput>& outputs, const std::vector<std::string>& inputs)
{
    for (const PlannedOutput& output : outputs)
        refuse_input(output.file.name(), inputs);
}

void commit(std::vector<PlannedOutput>& outputs)
{
    for (PlannedOutput& output : outputs)
        output.file.complete();
    for (PlannedOutput& output : outputs)
        output.file.commit();
}

} // namespace multipath
