#pragma once

#include <cstddef>
#include <string>

// What systems tell differently about the machine and the program.

namespace multipath {

/// [bytes] Memory of the machine, or of the container in which the program runs. Infinite if the system does not tell.
double machine_memory();

/// The file of this program; empty if the system does not tell.
std::string program_path();

/// [s] Processor time of the calling thread, without the time that other programs take.
double thread_seconds();

/// Asks the system for huge pages (2 MB) for a block of memory: fewer page faults when the memory is first touched,
/// fewer TLB misses afterwards. The contents do not change. Has no effect on blocks below 4 MB, or on systems without
/// such pages.
void ask_for_huge_pages(void* memory, std::size_t bytes);

/// Freed memory stays with the program, up to 64 MB, for what it allocates next. By default glibc returns most of it to
/// the system, which then clears the pages of every run of a study or selftest again. Has no effect with other C
/// libraries.
void keep_freed_memory();

} // namespace multipath
