#include "parallel/instruction_set.h"

#include <algorithm>
#include <cfloat>
#include <cstdlib>
#include <iterator>

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

// Fastest first.
constexpr NamedSet all_sets[] = {
#if defined(__x86_64__)
    {"avx512", [] { return __builtin_cpu_supports("avx512f") != 0; }},
    {"avx2", [] { return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0; }},
    {"sse2", always},
#elif defined(__aarch64__)
    {"neon", always},
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
#if defined(__x86_64__)
    __builtin_cpu_init(); // needed if kernels are chosen before main
#endif
    const NamedSet* named = set_named(instruction_set);
    return named != nullptr && named >= limit() && named->is_supported();
}

std::vector<std::string> instruction_sets()
{
    std::vector<std::string> names;
    for (const NamedSet& set : all_sets)
        names.emplace_back(set.name);
    return names;
}

bool kernel_limit_is_known()
{
    const char* name = std::getenv("MULTIPATH_KERNELS");
    return name == nullptr || set_named(name) != nullptr;
}

} // namespace multipath
