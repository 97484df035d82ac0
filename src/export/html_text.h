#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace multipath {

/// Text as HTML holds it, between tags or in quotation marks.
std::string html_escaped(const std::string& text);

/// The inverse of html_escaped(), and of svg_escaped().
std::string html_unescaped(std::string_view text);

/// How the line begins and ends that holds a part of a page's record, in its head.
constexpr std::string_view html_record_begin = "<meta name=\"multipath\" content=\"";
constexpr std::string_view html_record_end = "\">";

/// The line for a part of the record, such as "command: multipath solve room.obj". As metadata, because in a comment
/// two hyphens must not follow each other.
std::string html_record_line(const std::string& fact);

/// The text with new_text(what is between them) instead of every `open`, the next `close` and what is between them.
std::string replaced_between(const std::string& text, std::string_view open, std::string_view close,
                             const std::function<std::string(const std::string& between)>& new_text);

} // namespace multipath
