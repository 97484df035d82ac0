#ifdef _WIN32

#include "base/platform/files.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <io.h>
#include <windows.h>

namespace multipath {

const std::string_view folder_separators = "/\\:";
const bool names_ignore_case = true;

namespace {

/// The number of the C library for an error of the system.
int error_number(DWORD error)
{
    switch (error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_NAME:
        return ENOENT;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS:
        return EEXIST;
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
    case ERROR_WRITE_PROTECT:
        return EACCES;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
        return ENOSPC;
    default:
        return EIO;
    }
}

/// Opens a file; -1: see errno. With FILE_SHARE_DELETE it can be renamed and removed while it is open.
int opened(const std::string& path, DWORD disposition, DWORD sharing)
{
    const HANDLE handle =
        CreateFileA(path.c_str(), GENERIC_WRITE, sharing, nullptr, disposition, FILE_ATTRIBUTE_NORMAL, nullptr);
    if (handle == INVALID_HANDLE_VALUE) {
        errno = error_number(GetLastError());
        return -1;
    }
    return _open_osfhandle(reinterpret_cast<intptr_t>(handle), _O_WRONLY | _O_BINARY);
}

} // namespace

int create_file(const std::string& path, bool)
{
    return opened(path, CREATE_NEW, FILE_SHARE_READ | FILE_SHARE_DELETE);
}

int open_device(const std::string& path)
{
    return opened(path, OPEN_EXISTING, FILE_SHARE_READ | FILE_SHARE_WRITE);
}

int copy_standard_output()
{
    return _dup(1);
}

int write_all(int descriptor, std::string_view bytes)
{
    while (!bytes.empty()) {
        const int written =
            _write(descriptor, bytes.data(), static_cast<unsigned>(std::min<std::size_t>(bytes.size(), 1 << 30)));
        if (written < 0) {
            const bool is_pipe = GetFileType(reinterpret_cast<HANDLE>(_get_osfhandle(descriptor))) == FILE_TYPE_PIPE;
            return errno == EINVAL ? (is_pipe ? EPIPE : error_number(_doserrno)) : errno;
        }
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

int flush(int descriptor)
{
    return _commit(descriptor) != 0 ? errno : 0;
}

int close_file(int descriptor)
{
    return _close(descriptor) != 0 ? errno : 0;
}

int check_writable(const std::string& path)
{
    const DWORD attributes = GetFileAttributesA(path.c_str());
    return attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_READONLY) != 0 ? EACCES : 0;
}

int rename_over(const char* from, const char* to) noexcept
{
    return MoveFileExA(from, to, MOVEFILE_REPLACE_EXISTING) == 0 ? error_number(GetLastError()) : 0;
}

void remove_file(const char* path) noexcept
{
    DeleteFileA(path);
}

} // namespace multipath

#endif
