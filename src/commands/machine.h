#pragma once

#include <string>

namespace multipath {

/// The processor's name as the system tells it, else the kind of machine.
std::string processor_name();

/// Today, "2026-11-21" (UTC).
std::string today();

} // namespace multipath
