#include "cli/files/output_file.h"

#include "cli/options/usage_error.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

// A result must never be incomplete: not after a full disk, Ctrl-C or a crash. So the bytes go to the temporary file
// ".NAME.XXXXXX.part" in the target's folder, reach the disk (fsync), and get the target's name in one atomic step
// (rename). The temporary file is created before the work, so that a missing or protected folder is reported early.
// Devices, pipes and standard output cannot be renamed and are written directly.

namespace multipath {

namespace {

const std::string standard_output = "standard output";

[[noreturn]] void fail(const std::string& name, int error)
{
    const std::string message = "cannot write " + name + ": " + std::generic_category().message(error);
    if (error == EPIPE && name == standard_output)
        throw ReaderGone(message);
    throw OutputError(message);
}

/// Writes all bytes. Returns 0 or the error number.
int write_all(int descriptor, std::string_view bytes)
{
    while (!bytes.empty()) {
        // The largest single write that every system takes is just under 2^31 bytes.
        const ssize_t written = ::write(descriptor, bytes.data(), std::min<std::size_t>(bytes.size(), 1 << 30));
        if (written < 0 && errno != EINTR)
            return errno;
        bytes.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
    }
    return 0;
}

/// Flushes the folder of the path to the disk, so that a new name in it survives a crash. Returns 0 or EIO; folders
/// that may not be read, or have no fsync, are left to the system.
int sync_folder_of(const std::string& path)
{
    const std::string folder = folder_of(path);
    const int descriptor = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return 0;
    const int error = fsync(descriptor) != 0 && errno == EIO ? errno : 0;
    close(descriptor);
    return error;
}

} // namespace

std::string follow_links(const std::string& name)
{
    std::string path = name;
    for (int links = 0; links < 40; ++links) {
        std::string target(4096, '\0');
        const ssize_t length = readlink(path.c_str(), &target[0], target.size());
        if (length < 0)
            return path;
        target.resize(static_cast<std::size_t>(length));
        path = target[0] == '/' ? target : folder_of(path) + target;
    }
    fail(name, ELOOP);
}

void make_folder(const std::string& path)
{
    struct stat status = {};
    if (mkdir(path.c_str(), 0777) != 0 && errno != EEXIST)
        throw OutputError("cannot make the folder " + path + ": " + std::generic_category().message(errno));
    if (stat(path.c_str(), &status) != 0 || !S_ISDIR(status.st_mode))
        throw OutputError("cannot write into " + path + ": it is not a folder");
}

OutputFile::OutputFile(const std::string& path) : name_(path == "-" ? standard_output : path)
{
    struct stat status = {};
    const bool to_standard_output = path == "-";
    const bool exists = !to_standard_output && stat(path.c_str(), &status) == 0;
    if (to_standard_output) {
        descriptor_ = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
    } else if (!exists && errno != ENOENT) {
        fail(name_, errno);
    } else if (exists && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) {
        descriptor_ = open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    } else {
        target_ = follow_links(path);
        if (S_ISDIR(status.st_mode) || (!target_.empty() && target_.back() == '/'))
            fail(name_, EISDIR);
        if (target_.empty())
            fail(name_, ENOENT);
        if (exists && access(target_.c_str(), W_OK) != 0)
            fail(name_, errno);
        // A private target must not be readable by others before fchmod() below.
        const PartFile file = create_part_file(target_, exists ? 0600 : 0666);
        descriptor_ = file.descriptor;
        temporary_ = descriptor_ < 0 ? "" : file.path;
        unfinished_ = temporary_.empty() ? Unfinished() : Unfinished(temporary_, target_);
    }
    if (descriptor_ < 0 || (exists && !temporary_.empty() && fchmod(descriptor_, status.st_mode & 07777) != 0)) {
        const int error = errno;
        discard();
        fail(name_, error);
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
    if (const int error = write_all(descriptor_, bytes)) {
        discard();
        fail(name_, error);
    }
}

void OutputFile::complete()
{
    assert(descriptor_ >= 0);
    // EINVAL: the file system has no fsync. Some of these report errors at close(), so a copy of the descriptor is
    // closed.
    const int copy = dup(descriptor_);
    int error = copy < 0 ? errno : 0;
    if (error == 0 && !temporary_.empty() && fsync(copy) != 0 && errno != EINVAL)
        error = errno;
    if (copy >= 0 && close(copy) != 0 && error == 0)
        error = errno;
    if (error != 0) {
        discard();
        fail(name_, error);
    }
    unfinished_.complete();
}

void OutputFile::commit()
{
    complete();
    int error = 0;
    if (!temporary_.empty())
        error = std::rename(temporary_.c_str(), target_.c_str()) != 0 ? errno : sync_folder_of(target_);
    if (error != 0) {
        discard();
        fail(name_, error);
    }
    temporary_.clear();
    unfinished_ = {};
    close(std::exchange(descriptor_, -1)); // after the rename: closing the descriptor releases the lock
}

void OutputFile::discard() noexcept
{
    if (descriptor_ >= 0)
        close(std::exchange(descriptor_, -1));
    if (!temporary_.empty())
        unlink(temporary_.c_str());
    temporary_.clear();
    unfinished_ = {};
}

namespace {

void refuse_input(const std::string& path, const std::vector<std::string>& inputs)
{
    for (const std::string& input : inputs)
        if (same_file(path, input))
            throw UsageError("--output: '" + path + "' is an input; expected another file");
}

std::string lower_case_extension(const std::string& path)
{
    const std::size_t slash = path.find_last_of('/');
    const std::size_t dot = path.find_last_of('.');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash))
        return "";
    std::string extension = path.substr(dot);
    for (char& c : extension)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

} // namespace

bool same_file(const std::string& a, const std::string& b)
{
    struct stat status_a = {};
    struct stat status_b = {};
    const auto same = [&] { return status_a.st_dev == status_b.st_dev && status_a.st_ino == status_b.st_ino; };
    if (stat(a.c_str(), &status_a) == 0 && stat(b.c_str(), &status_b) == 0)
        return same();
    // Files that do not exist yet: the same name in the same folder.
    const std::string end_a = follow_links(a);
    const std::string end_b = follow_links(b);
    const auto folder = [](const std::string& path) {
        return path[0] == '/' ? folder_of(path) : "./" + folder_of(path);
    };
    const auto name = [](const std::string& path) { return path.substr(folder_of(path).size()); };
    return !end_a.empty() && !end_b.empty() && name(end_a) == name(end_b) &&
           stat(folder(end_a).c_str(), &status_a) == 0 && stat(folder(end_b).c_str(), &status_b) == 0 && same();
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
