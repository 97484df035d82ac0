#include "base/file_bytes.h"

#include "base/errors.h"
#include "base/platform/machine.h"
#include "base/text_format.h"

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <system_error>
#include <type_traits>

namespace multipath {

std::filesystem::path path_of(const std::string& name)
{
    if constexpr (std::is_same_v<std::filesystem::path::value_type, char>)
        return name;
    else
        return std::filesystem::u8path(valid_utf8(name));
}

std::string bytes_of_file(const std::string& path)
{
    namespace fs = std::filesystem;
    const auto refuse = [&](const std::string& reason) { throw InputError(path + ": cannot be read: " + reason); };
    const auto refuse_error = [&](int error) { refuse(std::generic_category().message(error)); };
    std::error_code unknown;
    const fs::file_status status = fs::status(path_of(path), unknown);
    if (fs::is_character_file(status) || fs::is_block_file(status))
        refuse("a device; expected a file or a pipe");
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file)
        refuse_error(fs::is_directory(status) ? EISDIR : errno); // Windows refuses to open folders

    constexpr std::size_t more = std::size_t{1} << 20;
    const bool is_file = fs::is_regular_file(status);
    std::string bytes;
    if (is_file) {
        bytes.reserve(static_cast<std::size_t>(fs::file_size(path_of(path), unknown)) + more);
        ask_for_huge_pages(bytes.data(), bytes.capacity());
    }
    for (std::size_t got = more; got == more;) {
        const std::size_t length = bytes.size();
        bytes.resize(length + more);
        got = std::fread(bytes.data() + length, 1, more, file.get());
        if (std::ferror(file.get()) != 0)
            refuse_error(errno);
        bytes.resize(length + got);
        if (!is_file && bytes.size() > std::size_t{1} << 30)
            refuse("more than 1 GiB from a pipe; expected a file");
    }
    return bytes;
}

} // namespace multipath
