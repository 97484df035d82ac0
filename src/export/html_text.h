#pragma once

#include <string>

namespace multipath {

/// Text as HTML holds it, between tags or in quotation marks.
std::string html_escaped(const std::string& text);

/// The line of a page's head for a part of its record, such as "command: multipath solve room.obj". As metadata,
/// because in a comment two hyphens must not follow each other.
std::string html_record_line(const std::string& fact);

/// Bytes as text (RFC 4648), for a page that holds files.
std::string base64(const std::string& bytes);

} // namespace multipath
