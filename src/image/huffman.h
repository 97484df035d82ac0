#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Lengths of the best prefix code without code words longer than `limit` bits; 0 for symbols of frequency 0. At least
/// two symbols get a code, because some decoders refuse a lonely one. Needs 2 ... 2^limit symbols.
std::vector<std::uint8_t> code_lengths(std::vector<std::uint32_t> frequencies, std::size_t limit);

/// The canonical code words for such lengths (RFC 1951, section 3.2.2), first bit lowest as deflate stores them.
std::vector<std::uint16_t> code_words(const std::vector<std::uint8_t>& lengths);

} // namespace multipath
