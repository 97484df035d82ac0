#pragma once

#include <string>

namespace multipath {

/// Text as HTML holds it, between tags or in quotation marks.
std::string html_escaped(const std::string& text);

} // namespace multipath
