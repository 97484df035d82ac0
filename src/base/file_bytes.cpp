#include "base/file_bytes.h"

#include "base/errors.h"
#include "base/platform/files.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace multipath {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(int error)
{
    throw std::runtime_error(std::generic_category().message(error));
}

/// Reads a file to its end. Throws if there is more than `most` [bytes].
std::vector<char> read_all(const std::string& path, std::size_t most)
{
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) {
        const int error = errno;
        std::error_code unknown;
        fail(fs::is_directory(path, unknown) ? EISDIR : error); // Windows refuses to open folders
    }
    constexpr std::size_t more = std::size_t{1} << 20;
    std::vector<char> bytes;
    while (bytes.size() <= most) {
        const std::size_t length = bytes.size();
        bytes.resize(length + more);
        const std::size_t got = std::fread(bytes.data() + length, 1, more, file.get());
        if (std::ferror(file.get()) != 0)
            fail(errno);
        bytes.resize(length + got);
        if (got < more)
            return bytes;
    }
    throw std::runtime_error("more than 1 GiB from a pipe; expected a file");
}

} // namespace

FileBytes::FileBytes(const std::string& path)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_character_file(status) || fs::is_block_file(status))
        throw std::runtime_error("a device; expected a file or a pipe");
    const MappedFile mapped = map_file(path);
    if (!mapped.owner) {
        const bool is_file = fs::is_regular_file(status);
        *this = FileBytes(read_all(path, is_file ? std::numeric_limits<std::size_t>::max() : std::size_t{1} << 30));
        return;
    }
    owner_ = mapped.owner;
    data_ = mapped.data;
    size_ = mapped.size;
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
