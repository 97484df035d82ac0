#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// The bytes of a file, in whose memory the system keeps only what is being read: of many large files at a time, too.
/// Immutable; copies share the bytes.
class FileBytes
{
public:
    /// Of a file, or of what a pipe brings until it ends. Throws std::runtime_error that says why there are none:
    /// "Permission denied".
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
