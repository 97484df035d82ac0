#include "cli/files/output_file.h"

#include "base/errors.h"
#include "base/file_bytes.h"
#include "base/platform/files.h"
#include "base/text_format.h"
#include "scene/text/text_words.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <random>
#include <system_error>
#include <utility>

namespace multipath {

namespace fs = std::filesystem;

std::string folder_of(const std::string& path)
{
    return path.substr(0, path.find_last_of(folder_separators) + 1); // npos + 1 is 0
}

// A signal handler may neither wait for a lock nor use the heap, which another thread may be changing at that moment.
// So the names are kept in slots of a fixed size, each with an atomic state.
struct UnfinishedSlot
{
    enum class State { empty, changing, full, complete };

    std::atomic<State> state{State::empty};
    std::array<char, 4096> path{}; ///< no system opens longer ones
    std::array<char, 4096> target{};
};

namespace {

std::array<UnfinishedSlot, 64> slots;
static_assert(std::atomic<UnfinishedSlot::State>::is_always_lock_free, "a signal handler reads it");

} // namespace

void ForgetUnfinished::operator()(UnfinishedSlot* slot) const noexcept
{
    slot->state = UnfinishedSlot::State::empty;
}

Unfinished unfinished(const std::string& path, const std::string& target)
{
    for (UnfinishedSlot& slot : slots) {
        UnfinishedSlot::State expected = UnfinishedSlot::State::empty;
        if (std::max(path.size(), target.size()) >= slot.path.size() ||
            !slot.state.compare_exchange_strong(expected, UnfinishedSlot::State::changing))
            continue;
        std::memcpy(slot.path.data(), path.c_str(), path.size() + 1);
        std::memcpy(slot.target.data(), target.c_str(), target.size() + 1);
        slot.state = UnfinishedSlot::State::full;
        return Unfinished(&slot);
    }
    return nullptr;
}

void complete(const Unfinished& file) noexcept
{
    if (file)
        file->state = UnfinishedSlot::State::complete;
}

void settle_unfinished(void (*not_written)(const char* target)) noexcept
{
    for (const UnfinishedSlot& slot : slots) {
        const UnfinishedSlot::State state = slot.state;
        if (state == UnfinishedSlot::State::complete && rename_over(slot.path.data(), slot.target.data()) == 0)
            continue;
        if (state == UnfinishedSlot::State::full || state == UnfinishedSlot::State::complete) {
            remove_file(slot.path.data());
            not_written(slot.target.data());
        }
    }
}

// A result must never be incomplete: not after a full disk, Ctrl-C or a crash. So the bytes go to the temporary file
// ".NAME.XXXXXX.part" in the target's folder, reach the disk (fsync), and get the target's name in one atomic step
// (rename). The temporary file is created before the work, so that a missing or protected folder is reported early.
// Devices, pipes and standard output cannot be renamed and are written directly.

namespace {

const std::string standard_output = "standard output";

/// Creates the temporary file of a target, ".NAME.XXXXXX.part" in its folder, sets its path and returns its descriptor;
/// -1: see errno. `is_private`: only the user may read it.
int create_part_file(const std::string& target, bool is_private, std::string& path)
{
    // 200 bytes of the name leave room for the rest below the usual limit of 255.
    const std::string start = folder_of(target) + "." + target.substr(folder_of(target).size(), 200) + ".";
    std::random_device random;
    int descriptor = -1;
    for (int attempt = 0; attempt < 100 && descriptor < 0; ++attempt) {
        std::string letters(6, 'a');
        for (char& letter : letters)
            letter = static_cast<char>('a' + random() % 26);
        path = start + letters + ".part";
        descriptor = create_file(path, is_private);
        if (descriptor < 0 && errno != EEXIST)
            break;
    }
    return descriptor;
}

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
        const fs::path target = fs::read_symlink(path_of(path), error);
        if (error)
            return path;
        path = (target.is_absolute() ? "" : folder_of(path)) + target.u8string();
    }
    fail(name, ELOOP);
}

} // namespace

void make_folder(const std::string& path)
{
    std::error_code error;
    fs::create_directory(path_of(path), error);
    std::error_code unknown;
    if (fs::is_directory(path_of(path), unknown))
        return;
    throw OutputError("cannot make the folder " + path + ": " + (error ? error.message() : "it is not a folder"));
}

OutputFile::OutputFile(const std::string& path) : name_(path == "-" ? standard_output : path)
{
    if (path == "-") {
        open(copy_standard_output());
        return;
    }
    std::error_code error;
    const fs::file_status status = fs::status(path_of(path), error);
    if (status.type() == fs::file_type::none)
        fail(name_, error.value());
    const bool is_special = fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
    // On Windows, the full path of NUL.csv is that of a device, as which it is also missing.
    if (is_special || fs::absolute(path_of(path), error).u8string().compare(0, 4, "\\\\.\\") == 0) {
        open(open_device(path));
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
    std::string path_of_part;
    open(create_part_file(target_, fs::exists(status), path_of_part));
    temporary_ = path_of_part;
    unfinished_ = unfinished(temporary_, target_);
    if (fs::exists(status))
        fs::permissions(path_of(temporary_), status.permissions(), error);
    if (error && fs::exists(status)) {
        discard();
        fail(name_, error.value());
    }
}

void OutputFile::open(int descriptor)
{
    if (descriptor < 0)
        fail(name_, errno);
    descriptor_ = descriptor;
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
    if (!temporary_.empty())
        discard_at(flush(descriptor_));
    multipath::complete(unfinished_);
}

void OutputFile::commit()
{
    complete();
    if (!temporary_.empty())
        discard_at(rename_over(temporary_.c_str(), target_.c_str()));
    temporary_.clear();
    unfinished_.reset();
    close_file(std::exchange(descriptor_, -1));
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
    unfinished_.reset();
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

} // namespace

bool same_file(const std::string& a, const std::string& b)
{
    std::error_code error;
    if (fs::exists(path_of(a), error) && fs::exists(path_of(b), error))
        return fs::equivalent(path_of(a), path_of(b), error);
    // Files that do not exist yet: the same name in the same folder.
    const auto place = [&](const std::string& path) {
        return fs::weakly_canonical(fs::absolute(path_of(follow_links(path)), error), error).u8string();
    };
    return names_ignore_case ? equal_but_for_case(place(a), place(b)) : place(a) == place(b);
}

std::string_view output_extension(const std::string& path, const std::vector<std::string_view>& extensions)
{
    if (path == "-")
        return extensions.front();
    const std::string name = lower_case(path.substr(folder_of(path).size()));
    std::string_view longest;
    for (const std::string_view known : extensions)
        if (known.size() > longest.size() && known.size() <= name.size() &&
            known == std::string_view(name).substr(name.size() - known.size()))
            longest = known;
    if (!longest.empty())
        return longest;
    throw UsageError("--output: '" + path + "' does not end in a known extension; expected one of " + join(extensions));
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
