#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

// What the innermost loops are compiled for (parallel/lanes): on x86-64 avx512, avx2 (with FMA) and sse2, on 64-bit ARM
// neon, on POWER vsx where the compiler may use it; plain C++ everywhere.

/// May loops for this instruction set run? The processor must have it, and the environment variable MULTIPATH_KERNELS,
/// if it names an instruction set, allows none faster than that. So what slower processors compute can be tested on
/// fast ones.
bool usable(std::string_view instruction_set);

/// Of kernels that do the same, each compiled for the instruction set of its name, those that may run, in this order.
template <class Kernel>
std::vector<const Kernel*> usable_kernels(std::initializer_list<const Kernel*> kernels)
{
    std::vector<const Kernel*> result;
    for (const Kernel* kernel : kernels)
        if (usable(kernel->name))
            result.push_back(kernel);
    return result;
}

/// The names of all that this program was compiled for, the fastest first.
std::vector<std::string> instruction_sets();

/// Is MULTIPATH_KERNELS, if it is set, the name of one of them? All that the processor has are usable otherwise.
bool kernel_limit_is_known();

} // namespace multipath
