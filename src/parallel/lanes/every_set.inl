// Compiles kernels for every instruction set of the processor's family: one source, KERNELS, included once for each, in a
// namespace of its own, after the types of lanes (plain.inl, or vector.inl for LANE_BYTES side by side). Each defines
// `table`; EVERY_TABLE lists their addresses, the fastest first.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

#define LANE_SET plain
#define LANE_SET_NAME "plain"
#define LANE_BYTES 0
#define LANE_TARGET
#include "parallel/lanes/one_set.inl"

#if defined(__x86_64__)

#define LANE_SET sse2
#define LANE_SET_NAME "sse2"
#define LANE_BYTES 16
#define LANE_TARGET __attribute__((target("sse2")))
#include "parallel/lanes/one_set.inl"

#define LANE_SET avx2
#define LANE_SET_NAME "avx2"
#define LANE_BYTES 32
#define LANE_TARGET __attribute__((target("avx2,fma")))
#include "parallel/lanes/one_set.inl"

#define LANE_SET avx512
#define LANE_SET_NAME "avx512"
#define LANE_BYTES 64
#define LANE_TARGET __attribute__((target("avx512f")))
#include "parallel/lanes/one_set.inl"

#define EVERY_TABLE &avx512::table, &avx2::table, &sse2::table, &plain::table

#elif defined(__aarch64__) // every processor of the family has it

#define LANE_SET neon
#define LANE_SET_NAME "neon"
#define LANE_BYTES 16
#define LANE_TARGET
#include "parallel/lanes/one_set.inl"

#define EVERY_TABLE &neon::table, &plain::table

#elif defined(__VSX__) // the compiler's default for processors of the order of bytes that Linux has there

#define LANE_SET vsx
#define LANE_SET_NAME "vsx"
#define LANE_BYTES 16
#define LANE_TARGET
#include "parallel/lanes/one_set.inl"

#define EVERY_TABLE &vsx::table, &plain::table

#else

#define EVERY_TABLE &plain::table

#endif

#undef KERNELS
