#include "cli/version.h"

#include "parallel/instruction_set.h"

namespace multipath {

namespace {

constexpr char sources[] =
#include "cli/sources_checksum.inc"
    ;

std::string compiler()
{
#if defined(__clang__)
    return "clang++ " + std::to_string(__clang_major__) + "." + std::to_string(__clang_minor__) + "." +
           std::to_string(__clang_patchlevel__);
#elif defined(__GNUC__)
    return "g++ " + std::to_string(__GNUC__) + "." + std::to_string(__GNUC_MINOR__) + "." +
           std::to_string(__GNUC_PATCHLEVEL__);
#else
    return "an unknown compiler";
#endif
}

std::string usable_sets()
{
    std::string names;
    for (const std::string& name : instruction_sets())
        if (usable(name))
            names += (names.empty() ? "" : " ") + name;
    return names;
}

} // namespace

std::string version()
{
    return "multipath 1.0.0";
}

std::string sources_checksum()
{
    return sources;
}

std::string version_text()
{
    return version() + "\ncompiler: " + compiler() + "\ninstruction sets: " + usable_sets() + "\n";
}

} // namespace multipath
