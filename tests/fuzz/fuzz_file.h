#pragma once

#include "tests/scene/scratch_folder.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace multipath {

/// The bytes that the fuzzer made up, as text.
inline std::string_view fuzz_text(const std::uint8_t* data, std::size_t size)
{
    return {reinterpret_cast<const char*>(data), size};
}

/// A folder for the readers, which take names of files.
using FuzzFolder = ScratchFolder;

} // namespace multipath
