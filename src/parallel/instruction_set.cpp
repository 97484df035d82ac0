#include "parallel/instruction_set.h"

#include "base/lists.h"

#include <algorithm>
#include <cfloat>
#include <cstdlib>
#include <iterator>
#if defined(__x86_64__)
#include <cpuid.h>
#endif

#if FLT_EVAL_METHOD != 0
#error "Numbers are rounded to more digits than they have (x87), so results would differ: add -msse2 -mfpmath=sse"
#endif

namespace multipath {

namespace {

struct NamedSet
{
    std::string_view name;
    bool (*is_supported)(); ///< by this processor
};

constexpr bool always()
{
    return true;
}

#if defined(__x86_64__)

/// Features of the processor (Intel 64 Architectures Software Developer's Manual, volume 2, CPUID) that the system has
/// enabled by saving their registers (XGETBV). Compilers' own functions for this do not link everywhere.
struct Processor
{
    bool avx2 = false; ///< with fused multiply-add
    bool avx512 = false;

    Processor()
    {
        unsigned a = 0;
        unsigned b = 0;
        unsigned c = 0;
        unsigned d = 0;
        constexpr unsigned fma_and_xgetbv = 1u << 12 | 1u << 27;
        if (__get_cpuid(1, &a, &b, &c, &d) == 0 || (c & fma_and_xgetbv) != fma_and_xgetbv)
            return;
        unsigned saved = 0;
        __asm__("xgetbv" : "=a"(saved), "=d"(d) : "c"(0));
        if (__get_cpuid_count(7, 0, &a, &b, &c, &d) == 0)
            return;
        constexpr unsigned wide = 0x06;  // registers of 128 and 256 bits
        constexpr unsigned wider = 0xe6; // and of 512 bits, with masks
        avx2 = (saved & wide) == wide && (b & 1u << 5) != 0;
        avx512 = (saved & wider) == wider && (b & 1u << 16) != 0;
    }
};

const Processor& processor()
{
    static const Processor features;
    return features;
}

#endif

// Fastest first.
constexpr NamedSet all_sets[] = {
#if defined(__x86_64__)
    {"avx512", [] { return processor().avx512; }},
    {"avx2", [] { return processor().avx2; }},
    {"sse2", always},
#elif defined(__aarch64__)
    {"neon", always},
#elif defined(__wasm_simd128__)
    {"wasm", always},
#elif defined(__VSX__)
    {"vsx", always},
#endif
    {"plain", always}};

const NamedSet* set_named(std::string_view name)
{
    const auto* found =
        std::find_if(std::begin(all_sets), std::end(all_sets), [&](const NamedSet& set) { return set.name == name; });
    return found == std::end(all_sets) ? nullptr : found;
}

/// The fastest instruction set that MULTIPATH_KERNELS allows.
const NamedSet* limit()
{
    const char* name = std::getenv("MULTIPATH_KERNELS");
    const NamedSet* named = name == nullptr ? nullptr : set_named(name);
    return named == nullptr ? std::begin(all_sets) : named;
}

} // namespace

bool usable(std::string_view instruction_set)
{
    const NamedSet* named = set_named(instruction_set);
    return named != nullptr && named >= limit() && named->is_supported();
}

std::vector<std::string> instruction_sets()
{
    return mapped(all_sets, [](const NamedSet& set) { return std::string(set.name); });
}

bool kernel_limit_is_known()
{
    const char* name = std::getenv("MULTIPATH_KERNELS");
    return name == nullptr || set_named(name) != nullptr;
}

} // namespace multipath
