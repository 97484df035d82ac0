#pragma once

#include <string>
#include <string_view>

namespace multipath {

/// The text as valid UTF-8. Names and paths come from files of any age: a byte that is no part of a UTF-8 character is
/// taken for one of Latin-1, which is right for most old files and never invalid.
std::string utf8_text(std::string_view bytes);

} // namespace multipath
