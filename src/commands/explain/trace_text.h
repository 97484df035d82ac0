#pragma once

#include "explain/stage_trace.h"

#include <string>

// Traces of a run (explain/stage_trace.h) in words.

namespace multipath {

/// Breaks a text between words into lines of at most 110 columns, each with its line feed; only a longer word exceeds
/// the limit. The first line begins with `first` spaces, the others with `others` spaces.
std::string wrapped(const std::string& text, std::size_t first, std::size_t others);

/// The trace as plain text, wrapped to 110 columns, for readers who do not know the paper: a heading about the run,
/// what the stage does, and for each line the item that makes it, its hits and what it carries. Rows of tables are not
/// wrapped and may be longer where coordinates are large.
std::string trace_text(const TracedRun& run, const StageTrace& trace);

} // namespace multipath
