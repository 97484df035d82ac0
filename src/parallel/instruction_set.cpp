#include "parallel/instruction_set.h"

#include <array>
#include <cstdlib>
#include <optional>

namespace multipath {

namespace {

struct NamedSet
{
    InstructionSet set;
    const char* name;
};

constexpr std::array<NamedSet, 4> all_sets = {{{InstructionSet::avx512, "avx512"},
                                               {InstructionSet::avx2, "avx2"},
                                               {InstructionSet::sse2, "sse2"},
                                               {InstructionSet::plain, "plain"}}};

constexpr const char* limit_variable = "MULTIPATH_KERNELS";

bool processor_has(InstructionSet set)
{
#if defined(__x86_64__)
    __builtin_cpu_init(); // kernels may be chosen before main
    switch (set) {
    case InstructionSet::avx512:
        return __builtin_cpu_supports("avx512f");
    case InstructionSet::avx2:
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case InstructionSet::sse2:
    case InstructionSet::plain:
        break;
    }
    return true;
#else
    return set == InstructionSet::plain;
#endif
}

std::optional<InstructionSet> named_set(const std::string& name)
{
    for (const NamedSet& named : all_sets)
        if (named.name == name)
            return named.set;
    return std::nullopt;
}

} // namespace

bool usable(InstructionSet set)
{
    const char* limit = std::getenv(limit_variable);
    return processor_has(set) && (limit == nullptr || set <= named_set(limit).value_or(InstructionSet::avx512));
}

std::string usable_instruction_sets()
{
    std::string names;
    for (const NamedSet& named : all_sets)
        if (usable(named.set))
            names += (names.empty() ? "" : " ") + std::string(named.name);
    return names;
}

bool kernel_limit_is_known()
{
    const char* limit = std::getenv(limit_variable);
    return limit == nullptr || named_set(limit);
}

} // namespace multipath
