#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

// Instruction sets for which the innermost loops are compiled (parallel/lanes): avx512, avx2 (with FMA) and sse2 on
// x86-64, neon on 64-bit ARM, vsx on POWER if the compiler may use it, and plain C++ everywhere.

/// True if loops compiled for this instruction set may run: the program was compiled for the set, the processor has it,
/// and it is not faster than the set that the environment variable MULTIPATH_KERNELS names, if any. The variable lets
/// fast processors test the code for slower ones.
bool usable(std::string_view instruction_set);

/// Selects the usable ones from several equivalent kernels, in the given order. The member `name` of a kernel is the
/// name of its instruction set.
template <class Kernel>
std::vector<const Kernel*> usable_kernels(std::initializer_list<const Kernel*> kernels)
{
    std::vector<const Kernel*> result;
    for (const Kernel* kernel : kernels)
        if (usable(kernel->name))
            result.push_back(kernel);
    return result;
}

/// Names of all instruction sets that this program was compiled for, fastest first.
std::vector<std::string> instruction_sets();

/// True if MULTIPATH_KERNELS is unset or names one of instruction_sets(). Any other value is ignored by usable().
bool kernel_limit_is_known();

} // namespace multipath
