// For every_set.inl. All is static, so that no code for a special processor can be taken for that of the rest of the
// program. KERNEL_CODE is what functions must carry that are expanded in place, KERNEL_ENTRY those that are called.

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
