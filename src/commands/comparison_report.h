#pragma once

#include "commands/result_comparison.h"
#include "export/json.h"

#include <string>

namespace multipath {

/// Some lines for a person.
std::string report_text(const Comparison& comparison);

/// The same for a program: the keys of `compare --json`.
JsonObject report_json(const Comparison& comparison);

} // namespace multipath
