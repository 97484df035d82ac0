// Compiles the kernels in the file KERNELS once for every instruction set of the processor family. Each copy has its
// own namespace and follows the lane types: plain.inl, or vector.inl for vectors of LANE_BYTES. Each copy defines
// `table`; EVERY_TABLE lists the addresses of all tables, fastest first.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
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
#if defined(__clang__) && __clang_major__ >= 18 && __clang_major__ < 22 // vectors of 64 bytes are a feature of their own
#define LANE_TARGET __attribute__((target("avx512f,evex512")))
#else
#define LANE_TARGET __attribute__((target("avx512f")))
#endif
#include "parallel/lanes/one_set.inl"

#define EVERY_TABLE &avx512::table, &avx2::table, &sse2::table, &plain::table

#elif defined(__aarch64__) // every processor of the family has NEON

#define LANE_SET neon
#define LANE_SET_NAME "neon"
#define LANE_BYTES 16
#define LANE_TARGET
#include "parallel/lanes/one_set.inl"

#define EVERY_TABLE &neon::table, &plain::table

#elif defined(__wasm_simd128__) // by -msimd128; a browser that lacks it cannot load the module

#define LANE_SET wasm
#define LANE_SET_NAME "wasm"
#define LANE_BYTES 16
#define LANE_TARGET
#include "parallel/lanes/one_set.inl"

#define EVERY_TABLE &wasm::table, &plain::table

#elif defined(__VSX__) // the default of compilers for little-endian POWER, which Linux uses

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
