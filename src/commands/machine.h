#pragma once

#include <string>

namespace multipath {

/// The processor's name as the system tells it, else the kind of machine.
std::string processor_name();

/// [bytes] What the machine has, or the container that the program runs in. Infinite where the system does not tell.
double machine_memory();

/// Today, "2026-11-21" (UTC).
std::string today();

} // namespace multipath
