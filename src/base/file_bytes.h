#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// The bytes of a file: memory-mapped, read from a pipe, or already in memory. Immutable; copies share the bytes.
class FileBytes
{
public:
    /// Maps a regular file, or reads a pipe to its end. Throws std::runtime_error if the file cannot be read, is a
    /// device, or is a pipe that gives more than 1 GiB. The message is the reason alone, such as "Permission denied".
    explicit FileBytes(const std::string& path);
    /// Takes bytes that are already in memory.
    explicit FileBytes(std::vector<char> bytes);

    const char* data() const { return data_; }
    std::size_t size() const { return size_; }
    std::string_view view() const { return {data_, size_}; }

private:
    std::shared_ptr<const void> owner_;
    const char* data_ = nullptr;
    std::size_t size_ = 0;
};

/// Copies a whole file or pipe into a string. Throws InputError if FileBytes cannot read it, with a message such as
/// "room.csv: cannot be read: Permission denied".
std::string bytes_of_file(const std::string& path);

} // namespace multipath
