#ifndef _WIN32

#include "base/platform/files.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace multipath {

const std::string_view folder_separators = "/";
const bool names_ignore_case = false;

namespace {

int flush(int descriptor)
{
#ifdef F_FULLFSYNC
    if (fcntl(descriptor, F_FULLFSYNC) == 0) // the fsync() of macOS leaves the bytes in the cache of the disk
        return 0;
#endif
    return fsync(descriptor);
}

} // namespace

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

int finish_writing(int descriptor, bool to_disk)
{
    // EINVAL: the file system has no fsync. Some of these report errors at close(), so a copy of the descriptor is
    // closed.
    const int copy = dup(descriptor);
    int error = copy < 0 ? errno : 0;
    if (error == 0 && to_disk && flush(copy) != 0 && errno != EINVAL)
        error = errno;
    if (copy >= 0 && close(copy) != 0 && error == 0)
        error = errno;
    return error;
}

int flush_folder(const std::string& folder)
{
    const int descriptor = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return 0; // a folder that may not be read is left to the system
    const int error = fsync(descriptor) != 0 && errno == EIO ? errno : 0;
    close(descriptor);
    return error;
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

MappedFile map_file(const std::string& path)
{
    MappedFile file;
    const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    struct stat status = {};
    if (descriptor >= 0 && fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0) {
        const auto size = static_cast<std::size_t>(status.st_size);
        void* const memory = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
        if (memory != MAP_FAILED)
            file = {std::shared_ptr<const void>(
                        memory, [size](const void* mapped) { munmap(const_cast<void*>(mapped), size); }),
                    static_cast<const char*>(memory), size};
    }
    if (descriptor >= 0)
        close(descriptor);
    return file;
}

} // namespace multipath

#endif
