#pragma once

#include <string>

namespace multipath {

/// Escapes text for HTML, for use between tags or in a double-quoted attribute.
std::string html_escaped(const std::string& text);

/// Formats one line of a page's provenance record, such as "command: multipath solve room.obj", as a <meta> element of
/// its head. An HTML comment would not do: it must not contain "--", which options begin with.
std::string html_record_line(const std::string& fact);

/// Base64 encoding (RFC 4648), to embed files in a page.
std::string base64(const std::string& bytes);

} // namespace multipath
