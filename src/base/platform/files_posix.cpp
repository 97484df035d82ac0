#ifndef _WIN32

#include "base/platform/files.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace multipath {

const std::string_view folder_separators = "/";
#ifdef __APPLE__
const bool names_ignore_case = true; // as most of its disks do
#else
const bool names_ignore_case = false;
#endif

int create_file(const std::string& path, bool is_private)
{
    return open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, is_private ? 0600 : 0666);
}

int open_device(const std::string& path)
{
    return open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
}

int copy_standard_output()
{
    return fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
}

int write_all(int descriptor, std::string_view bytes)
{
    while (!bytes.empty()) {
        // The largest single write that every system takes is just under 2^31 bytes.
        const ssize_t written = write(descriptor, bytes.data(), std::min<std::size_t>(bytes.size(), 1 << 30));
        if (written < 0 && errno != EINTR)
            return errno;
        bytes.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
    }
    return 0;
}

int flush(int descriptor)
{
    return fsync(descriptor) != 0 && errno != EINVAL ? errno : 0; // EINVAL: the file system has no fsync
}

int close_file(int descriptor)
{
    return close(descriptor) != 0 ? errno : 0;
}

int check_writable(const std::string& path)
{
    return access(path.c_str(), W_OK) != 0 ? errno : 0;
}

int rename_over(const char* from, const char* to) noexcept
{
    return std::rename(from, to) != 0 ? errno : 0;
}

void remove_file(const char* path) noexcept
{
    unlink(path);
}

} // namespace multipath

#endif
