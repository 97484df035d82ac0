#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace multipath {

/// Text as HTML holds it, between tags or in quotation marks.
std::string html_escaped(const std::string& text);

/// The line of a page's head for a part of its record, such as "command: multipath solve room.obj". As metadata,
/// because in a comment two hyphens must not follow each other.
std::string html_record_line(const std::string& fact);

/// The text with new_text(what is between them) instead of every `open`, the next `close` and what is between them.
std::string replaced_between(const std::string& text, std::string_view open, std::string_view close,
                             const std::function<std::string(const std::string& between)>& new_text);

/// Bytes as text (RFC 4648), for a page that holds files.
std::string base64(const std::string& bytes);

} // namespace multipath
