#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// The bytes of a memory-mapped file. Immutable; copies share the mapping.
class FileBytes
{
public:
    /// Maps a regular file, or reads a pipe to its end. Throws std::runtime_error with the reason, such as "Permission
    /// denied", also for a device and for more than 1 GiB from a pipe.
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

/// Reads a whole file. Throws InputError, such as "room.csv: cannot be read: Permission denied".
std::string bytes_of_file(const std::string& path);

} // namespace multipath
