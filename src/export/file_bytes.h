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
    /// Maps a file, or reads a pipe to its end. Throws std::runtime_error with the reason: "Permission denied".
    explicit FileBytes(const std::string& path);
    /// Bytes that are in memory already.
    explicit FileBytes(std::vector<char> bytes);

    const char* data() const { return data_; }
    std::size_t size() const { return size_; }
    std::string_view view() const { return {data_, size_}; }

private:
    std::shared_ptr<const void> owner_;
    const char* data_ = nullptr;
    std::size_t size_ = 0;
};

/// A copy of all bytes of a file. Throws InputError "room.csv: cannot be read: Permission denied".
std::string bytes_of_file(const std::string& path);

} // namespace multipath
