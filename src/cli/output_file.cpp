#include "cli/output_file.h"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <system_error>
#include <utility>

#include <csignal>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

// A result must never be half there: not after a full disk, not after Ctrl-C, not beside a crash. So the bytes go to
// ".NAME.XXXXXX.part" in the target's folder, reach the disk (fsync), and then take the target's name in one step
// (rename). The temporary is created before the work, which is when a missing or protected folder should be reported.
// Things that are not regular files (devices, pipes, standard output) have no such step and are written as they are.

namespace multipath {

namespace {

[[noreturn]] void fail(const std::string& name, int error)
{
    throw OutputError("cannot write " + name + ": " + std::generic_category().message(error));
}

std::string folder_of(const std::string& path)
{
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "" : path.substr(0, slash + 1);
}

/// Follows the links at the end of the path, also when the last one leads to a file that does not exist yet.
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

/// Six letters that differ between processes, files and tries; O_EXCL is what makes them unique.
std::string six_letters(unsigned attempt)
{
    const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
    auto bits =
        (static_cast<std::uint64_t>(now) + attempt) * 0x9E3779B97F4A7C15u ^ static_cast<std::uint64_t>(getpid());
    std::string letters;
    for (int i = 0; i < 6; ++i, bits /= 26)
        letters += static_cast<char>('a' + bits % 26);
    return letters;
}

/// While it lives, a write to a closed pipe or beyond the permitted file size is the error EPIPE or EFBIG instead of
/// the silent end of the program.
class WriteSignalsHeld
{
public:
    WriteSignalsHeld()
    {
        sigemptyset(&held_);
        sigaddset(&held_, SIGPIPE);
        sigaddset(&held_, SIGXFSZ);
        pthread_sigmask(SIG_BLOCK, &held_, &before_);
    }
    ~WriteSignalsHeld()
    {
        sigset_t pending;
        sigpending(&pending);
        int signal = 0;
        if (sigismember(&pending, SIGPIPE) == 1 || sigismember(&pending, SIGXFSZ) == 1)
            sigwait(&held_, &signal);
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    WriteSignalsHeld(const WriteSignalsHeld&) = delete;
    WriteSignalsHeld& operator=(const WriteSignalsHeld&) = delete;

private:
    sigset_t held_;
    sigset_t before_;
};

/// 0, or what went wrong.
int write_all(int descriptor, std::string_view bytes)
{
    const WriteSignalsHeld guard;
    while (!bytes.empty()) {
        // The largest single write that every system takes is just under 2^31 bytes.
        const ssize_t written = ::write(descriptor, bytes.data(), std::min<std::size_t>(bytes.size(), 1 << 30));
        if (written < 0 && errno != EINTR)
            return errno;
        bytes.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
    }
    return 0;
}

struct Temporary
{
    std::string path;
    int descriptor = -1; ///< -1: not created, errno says why
};

/// A new empty file beside the target. Until it is complete nobody may read what the target's owner keeps private.
Temporary create_beside(const std::string& target, mode_t mode)
{
    const std::string folder = folder_of(target);
    const std::string name = target.substr(folder.size(), 200); // leaves room for the rest below the usual limit of 255
    Temporary file;
    for (unsigned attempt = 0; attempt < 100 && file.descriptor < 0; ++attempt) {
        file.path = folder + "." + name + "." + six_letters(attempt) + ".part";
        file.descriptor = open(file.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        if (file.descriptor < 0 && errno != EEXIST)
            break;
    }
    return file;
}

} // namespace

OutputFile::OutputFile(const std::string& path) : name_(path == "-" ? "standard output" : path)
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
        const Temporary file = create_beside(target_, exists ? 0600 : 0666);
        descriptor_ = file.descriptor;
        temporary_ = descriptor_ < 0 ? "" : file.path;
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
      descriptor_(std::exchange(other.descriptor_, -1))
{
}

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept
{
    std::swap(name_, other.name_);
    std::swap(target_, other.target_);
    std::swap(temporary_, other.temporary_);
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

void OutputFile::write(std::string_view bytes)
{
    assert(descriptor_ >= 0);
    if (const int error = write_all(descriptor_, bytes)) {
        discard();
        fail(name_, error);
    }
}

void OutputFile::commit()
{
    assert(descriptor_ >= 0);
    // EINVAL: a file system that has no fsync.
    int error = !temporary_.empty() && fsync(descriptor_) != 0 && errno != EINVAL ? errno : 0;
    if (close(std::exchange(descriptor_, -1)) != 0 && error == 0)
        error = errno;
    if (error == 0 && !temporary_.empty() && std::rename(temporary_.c_str(), target_.c_str()) != 0)
        error = errno;
    if (error != 0) {
        discard();
        fail(name_, error);
    }
    temporary_.clear();
}

void OutputFile::discard() noexcept
{
    if (descriptor_ >= 0)
        close(std::exchange(descriptor_, -1));
    if (!temporary_.empty())
        unlink(temporary_.c_str());
    temporary_.clear();
}

} // namespace multipath
