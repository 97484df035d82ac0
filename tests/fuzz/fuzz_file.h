#pragma once

#include "cli/temporary_folder.h"

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

namespace multipath {

/// The bytes that the fuzzer made up, as text.
inline std::string_view fuzz_text(const std::uint8_t* data, std::size_t size)
{
    return {reinterpret_cast<const char*>(data), size};
}

/// A folder for the readers, which take names of files.
class FuzzFolder
{
public:
    /// Writes a file, over an older one of that name, and returns its path.
    std::string write(const std::string& name, std::string_view bytes) const
    {
        const std::string path = folder_.path() + "/" + name;
        std::ofstream(path, std::ios::binary) << bytes;
        return path;
    }

private:
    TemporaryFolder folder_;
};

} // namespace multipath
