#pragma once

#include "base/errors.h"

#include <string>

namespace multipath {

/// The message of the InputError that `work` ends with; empty if it ends well.
template <typename Work>
std::string problem_of(const Work& work)
{
    try {
        work();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

inline bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // namespace multipath
