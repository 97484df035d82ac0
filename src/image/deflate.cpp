// RFC 1951: literals and copies (lz77.h) in blocks, each with Huffman codes of its own. A block begins with the lengths
// of its code words, which are themselves run-length and Huffman coded.

#include "image/deflate.h"

#include "image/big_endian.h"
#include "image/checksum.h"
#include "image/huffman.h"
#include "image/lz77.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace multipath {

namespace {

constexpr std::size_t tokens_per_block = 32768;
constexpr std::uint32_t end_of_block = 256;
constexpr std::array<std::uint8_t, 19> header_order = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                       11, 4,  12, 3, 13, 2, 14, 1, 15};

/// Bits fill bytes from the lowest.
class BitWriter
{
public:
    void put(std::uint32_t bits, int count)
    {
        buffer_ |= std::uint64_t{bits} << filled_;
        for (filled_ += count; filled_ >= 8; filled_ -= 8, buffer_ >>= 8)
            bytes_ += static_cast<char>(buffer_ & 0xffu);
    }
    std::string finished()
    {
        put(0, 7); // pushes out what is left
        return std::move(bytes_);
    }

private:
    std::string bytes_;
    std::uint64_t buffer_ = 0;
    int filled_ = 0;
};

/// A code word with what follows it unchanged.
struct Symbol
{
    std::uint32_t code = 0;
    int extra_bits = 0;
    std::uint32_t extra = 0;
};

/// Ranges that double in size every `per_size` codes: how deflate numbers both lengths and distances from zero.
Symbol in_doubling_ranges(std::uint32_t value, std::uint32_t per_size)
{
    Symbol symbol;
    while (value >> symbol.extra_bits >= 2 * per_size)
        ++symbol.extra_bits;
    const auto size = static_cast<std::uint32_t>(symbol.extra_bits);
    symbol.code = size * per_size + (value >> size);
    symbol.extra = value & ((1u << size) - 1u);
    return symbol;
}

Symbol length_symbol(std::uint32_t length)
{
    if (length == 258)
        return {285, 0, 0};
    Symbol symbol = in_doubling_ranges(length - 3, 4);
    symbol.code += 257;
    return symbol;
}

Symbol distance_symbol(std::uint32_t distance)
{
    return in_doubling_ranges(distance - 1, 2);
}

/// A Huffman code, ready for writing.
struct Code
{
    Code(std::vector<std::uint32_t> frequencies, std::size_t limit)
        : lengths(code_lengths(std::move(frequencies), limit)), words(code_words(lengths))
    {
    }
    void put(Symbol symbol, BitWriter& writer) const
    {
        writer.put(words[symbol.code], lengths[symbol.code]);
        writer.put(symbol.extra, symbol.extra_bits);
    }

    std::vector<std::uint8_t> lengths;
    std::vector<std::uint16_t> words;
};

/// Code lengths with their repetitions as symbols 16 (previous), 17 and 18 (zeros).
std::vector<Symbol> run_lengths(const std::vector<std::uint8_t>& lengths)
{
    std::vector<Symbol> symbols;
    for (std::size_t i = 0; i < lengths.size();) {
        const auto different = std::find_if(lengths.begin() + static_cast<std::ptrdiff_t>(i), lengths.end(),
                                            [&](std::uint8_t length) { return length != lengths[i]; });
        const auto run = static_cast<std::uint32_t>(different - lengths.begin()) - static_cast<std::uint32_t>(i);
        const bool repeats = i > 0 && lengths[i] == lengths[i - 1];
        std::uint32_t taken = 1;
        if (lengths[i] == 0 && run >= 11) {
            taken = std::min(run, 138u);
            symbols.push_back({18, 7, taken - 11});
        } else if (lengths[i] == 0 && run >= 3) {
            taken = run;
            symbols.push_back({17, 3, taken - 3});
        } else if (repeats && run >= 3) {
            taken = std::min(run, 6u);
            symbols.push_back({16, 2, taken - 3});
        } else {
            symbols.push_back({lengths[i], 0, 0});
        }
        i += taken;
    }
    return symbols;
}

std::size_t without_trailing_zeros(const std::vector<std::uint8_t>& lengths, std::size_t at_least)
{
    std::size_t count = lengths.size();
    while (count > at_least && lengths[count - 1] == 0)
        --count;
    return count;
}

/// The block's two codes, for the decoder.
void put_codes(const Code& literals, const Code& distances, BitWriter& writer)
{
    const std::size_t literal_count = without_trailing_zeros(literals.lengths, 257);
    const std::size_t distance_count = without_trailing_zeros(distances.lengths, 1);
    std::vector<std::uint8_t> lengths(literals.lengths.begin(),
                                      literals.lengths.begin() + static_cast<std::ptrdiff_t>(literal_count));
    lengths.insert(lengths.end(), distances.lengths.begin(),
                   distances.lengths.begin() + static_cast<std::ptrdiff_t>(distance_count));
    const std::vector<Symbol> symbols = run_lengths(lengths);
    std::vector<std::uint32_t> frequencies(header_order.size(), 0);
    for (const Symbol& symbol : symbols)
        ++frequencies[symbol.code];
    const Code header(std::move(frequencies), 7);

    std::size_t header_count = header_order.size();
    while (header_count > 4 && header.lengths[header_order[header_count - 1]] == 0)
        --header_count;
    writer.put(static_cast<std::uint32_t>(literal_count - 257), 5);
    writer.put(static_cast<std::uint32_t>(distance_count - 1), 5);
    writer.put(static_cast<std::uint32_t>(header_count - 4), 4);
    for (std::size_t i = 0; i < header_count; ++i)
        writer.put(header.lengths[header_order[i]], 3);
    for (const Symbol& symbol : symbols)
        header.put(symbol, writer);
}

void put_block(const Token* first, const Token* last, bool final, BitWriter& writer)
{
    std::vector<std::uint32_t> literal_frequencies(286, 0);
    std::vector<std::uint32_t> distance_frequencies(30, 0);
    literal_frequencies[end_of_block] = 1;
    for (const Token* token = first; token != last; ++token) {
        ++literal_frequencies[token->length == 0 ? token->value : length_symbol(token->length).code];
        if (token->length > 0)
            ++distance_frequencies[distance_symbol(token->value).code];
    }
    const Code literals(std::move(literal_frequencies), 15);
    const Code distances(std::move(distance_frequencies), 15);

    writer.put(final ? 1 : 0, 1);
    writer.put(2, 2); // dynamic Huffman codes
    put_codes(literals, distances, writer);
    for (const Token* token = first; token != last; ++token) {
        literals.put(token->length == 0 ? Symbol{token->value, 0, 0} : length_symbol(token->length), writer);
        if (token->length > 0)
            distances.put(distance_symbol(token->value), writer);
    }
    literals.put({end_of_block, 0, 0}, writer);
}

} // namespace

std::string deflate(const std::string& bytes)
{
    const std::vector<Token> tokens = lz77_tokens(bytes);
    BitWriter writer;
    std::size_t first = 0;
    do {
        const std::size_t last = std::min(first + tokens_per_block, tokens.size());
        put_block(tokens.data() + first, tokens.data() + last, last == tokens.size(), writer);
        first = last;
    } while (first < tokens.size());
    return writer.finished();
}

std::string zlib_bytes(const std::string& bytes)
{
    std::string result = "\x78\x9c"; // deflate with a window of 32768 bytes, default effort, check bits
    result += deflate(bytes);
    return result + big_endian(adler32(bytes));
}

} // namespace multipath
