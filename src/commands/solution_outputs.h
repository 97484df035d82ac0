#pragma once

#include "cli/planned_outputs.h"
#include "commands/picture_options.h"
#include "radiosity/solve.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace multipath {

/// Is one of them of this format?
bool has_format(const std::vector<PlannedOutput>& outputs, OutputFormat format);

/// Does one of them show the scene from a camera, or with the exposure of such a picture?
bool has_view(const std::vector<PlannedOutput>& outputs);

/// Fills every output in its format, numbers before pictures before pages, so that what a signal costs can be made
/// again from the rest, and puts all into place. The comments go into the formats that have a place for them; `makers`
/// give the bytes of the formats that are made elsewhere, pages and states. Throws OutputError.
void write_outputs(std::vector<PlannedOutput>& outputs, const Scene& scene, const Solution& solution,
                   const PictureOptions& picture_options, const std::vector<std::string>& comments,
                   const std::map<OutputFormat, std::function<std::string()>>& makers);

} // namespace multipath
