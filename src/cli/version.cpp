#include "cli/version.h"

namespace multipath {

namespace {

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

std::string instruction_set()
{
#if defined(__AVX512F__)
    return "x86-64 with AVX-512";
#elif defined(__AVX2__)
    return "x86-64 with AVX2";
#elif defined(__x86_64__)
    return "x86-64 (SSE2)";
#elif defined(__aarch64__)
    return "aarch64 (NEON)";
#else
    return "plain C++";
#endif
}

} // namespace

std::string version()
{
    return "multipath 0.1.0";
}

std::string version_text()
{
    return version() + "\ncompiler: " + compiler() + "\ninstruction set: " + instruction_set() + "\n";
}

} // namespace multipath
