#pragma once

#include "study/curve.h"

#include <string>

namespace multipath {

/// A study as study_csv() wrote it; the fits are made anew. Throws InputError for a file that is no such table.
Study read_study(const std::string& path);

} // namespace multipath
