#pragma once

#include <string>
#include <vector>

namespace multipath {

/// What the innermost loops are compiled for, each faster than the one before it. avx2 stands for AVX2 with FMA.
enum class InstructionSet { plain, sse2, avx2, avx512 };

/// May loops for this instruction set run? The processor must have it, and the environment variable MULTIPATH_KERNELS,
/// if it names an instruction set, allows none faster than that. So what slower processors compute can be tested on
/// fast ones.
bool usable(InstructionSet set);

/// Of kernels that do the same, each compiled for an instruction set, those that may run, the fastest first.
template <class Kernel>
std::vector<const Kernel*> usable_kernels(const Kernel& avx512, const Kernel& avx2, const Kernel& sse2,
                                          const Kernel& plain)
{
    std::vector<const Kernel*> kernels;
    if (usable(InstructionSet::avx512))
        kernels.push_back(&avx512);
    if (usable(InstructionSet::avx2))
        kernels.push_back(&avx2);
    if (usable(InstructionSet::sse2))
        kernels.push_back(&sse2);
    kernels.push_back(&plain);
    return kernels;
}

/// The names of all that are usable, the fastest first, with blanks between them.
std::string usable_instruction_sets();

/// Is MULTIPATH_KERNELS, if it is set, the name of an instruction set? All that the processor has are usable otherwise.
bool kernel_limit_is_known();

} // namespace multipath
