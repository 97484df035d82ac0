#pragma once

#include <string>

namespace multipath {

/// What the innermost loops are compiled for, each faster than the one before it. avx2 stands for AVX2 with FMA.
enum class InstructionSet { plain, sse2, avx2, avx512 };

/// May loops for this instruction set run? The processor must have it, and the environment variable MULTIPATH_KERNELS,
/// if it names an instruction set, allows none faster than that. So what slower processors compute can be tested on
/// fast ones.
bool usable(InstructionSet set);

/// The names of all that are usable, the fastest first, with blanks between them.
std::string usable_instruction_sets();

/// Is MULTIPATH_KERNELS, if it is set, the name of an instruction set? All that the processor has are usable otherwise.
bool kernel_limit_is_known();

} // namespace multipath
