#include "base/file_bytes.h"

#include "base/errors.h"

#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/stat.h>
#include <system_error>
#include <utility>

namespace multipath {

namespace {

[[noreturn]] void fail()
{
    throw std::runtime_error(std::generic_category().message(errno));
}

/// Reads a file that cannot be mapped, such as a pipe, to its end. Throws if there is more than 1 GiB.
std::vector<char> read_all(std::FILE* file)
{
    constexpr std::size_t most = std::size_t{1} << 30;
    constexpr std::size_t more = std::size_t{1} << 20;
    std::vector<char> bytes;
    while (bytes.size() <= most) {
        const std::size_t length = bytes.size();
        bytes.resize(length + more);
        const std::size_t got = std::fread(bytes.data() + length, 1, more, file);
        if (std::ferror(file) != 0)
            fail();
        bytes.resize(length + got);
        if (got < more)
            return bytes;
    }
    throw std::runtime_error("more than 1 GiB from a pipe; expected a file");
}

} // namespace

FileBytes::FileBytes(const std::string& path)
{
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    struct stat status = {};
    if (!file || fstat(fileno(file.get()), &status) != 0)
        fail();
    if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode))
        throw std::runtime_error("a device; expected a file or a pipe");
    if (!S_ISREG(status.st_mode) || status.st_size == 0) {
        *this = FileBytes(read_all(file.get()));
        return;
    }
    size_ = static_cast<std::size_t>(status.st_size);
    void* const mapped = mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, fileno(file.get()), 0);
    if (mapped == MAP_FAILED)
        fail();
    owner_ = std::shared_ptr<const void>(
        mapped, [size = size_](const void* memory) { munmap(const_cast<void*>(memory), size); });
    data_ = static_cast<const char*>(mapped);
}

FileBytes::FileBytes(std::vector<char> bytes)
{
    const auto kept = std::make_shared<const std::vector<char>>(std::move(bytes));
    data_ = kept->data();
    size_ = kept->size();
    owner_ = kept;
}

std::string bytes_of_file(const std::string& path)
{
    try {
        return std::string(FileBytes(path).view());
    } catch (const std::runtime_error& error) {
        throw InputError(path + ": cannot be read: " + error.what());
    }
}

} // namespace multipath
