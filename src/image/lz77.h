#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// One step of a text written with references to what came before.
struct Token
{
    std::uint16_t length = 0; ///< 0 for a literal byte, otherwise 3 ... 258 bytes to copy
    std::uint16_t value = 0;  ///< the literal, or the distance back, 1 ... 32768
};

/// The bytes as literals and copies (Ziv and Lempel 1977) within the limits of deflate.
std::vector<Token> lz77_tokens(const std::string& bytes);

} // namespace multipath
