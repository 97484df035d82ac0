// One instruction set for every_set.inl. All functions have internal linkage, so that the linker cannot use code for a
// newer processor in the rest of the program. KERNEL_CODE marks functions that must be inlined, KERNEL_ENTRY those that
// are called through the table.

#define KERNEL_ENTRY LANE_TARGET
#if LANE_BYTES == 0
#define KERNEL_CODE inline
#include "parallel/lanes/plain.inl"
#else
#define KERNEL_CODE __attribute__((always_inline)) LANE_TARGET inline
#include "parallel/lanes/vector.inl"
#endif

#include KERNELS

#undef KERNEL_CODE
#undef KERNEL_ENTRY
#undef LANE_SET
#undef LANE_SET_NAME
#undef LANE_BYTES
#undef LANE_TARGET
