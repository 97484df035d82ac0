#include "cli/version.h"

#include "parallel/instruction_set.h"

namespace multipath {

namespace {

constexpr char sources[] =
#include "cli/sources_checksum.inc"
    ;

#if defined(__clang__)
constexpr char compiler[] = "clang++ " __clang_version__;
#else
constexpr char compiler[] = "g++ " __VERSION__;
#endif

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
    std::string text = version() + "\ncompiler: " + compiler + "\ninstruction sets:";
    for (const std::string& set : instruction_sets())
        text += usable(set) ? " " + set : "";
    return text + "\n";
}

} // namespace multipath
