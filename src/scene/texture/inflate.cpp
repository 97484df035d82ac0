// Decompression of a deflate stream (RFC 1951) in the zlib format (RFC 1950). A stream is a list of blocks, each stored
// or coded with two prefix codes: one for literal bytes and the lengths of matches, one for the distances of matches.

#include "base/checksum.h"
#include "base/errors.h"
#include "scene/texture/byte_reader.h"
#include "scene/texture/prefix_code.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace multipath {

namespace {

[[noreturn]] void throw_damaged_deflate()
{
    throw ImageError("has damaged pixel data");
}

constexpr std::array<std::uint8_t, 256> make_reversed_bytes()
{
    std::array<std::uint8_t, 256> reversed = {};
    for (unsigned byte = 0; byte < 256; ++byte)
        for (unsigned bit = 0; bit < 8; ++bit)
            reversed[byte] = static_cast<std::uint8_t>(reversed[byte] | (byte >> bit & 1) << (7 - bit));
    return reversed;
}

constexpr std::array<std::uint8_t, 256> reversed_byte = make_reversed_bytes();

/// The bytes with their bits in reverse order: a stream begins with the lowest bit of each byte.
std::string reversed_bytes(std::string_view bytes)
{
    std::string reversed(bytes);
    for (char& byte : reversed)
        byte = static_cast<char>(reversed_byte[static_cast<unsigned char>(byte)]);
    return reversed;
}

/// The code whose code words have these lengths; length 0 means that a symbol is not used (RFC 1951, 3.2.2).
PrefixCode deflate_code(const std::uint8_t* lengths, std::size_t symbols)
{
    PrefixCode::Counts counts = {};
    std::vector<std::uint16_t> sorted;
    for (unsigned length = 1; length <= 15; ++length)
        for (std::size_t symbol = 0; symbol < symbols; ++symbol)
            if (lengths[symbol] == length) {
                ++counts[length];
                sorted.push_back(static_cast<std::uint16_t>(symbol));
            }
    return {counts, std::move(sorted)};
}

class Inflater
{
public:
    Inflater(std::string_view stream, std::size_t size) : bits_(reversed_bytes(stream)), contents_(size) {}

    std::vector<std::uint8_t> contents()
    {
        const std::uint32_t method = number(8);
        const std::uint32_t flags = number(8);
        const bool has_dictionary = (flags & 0x20) != 0;
        if ((method & 15) != 8 || (256 * method + flags) % 31 != 0 || has_dictionary)
            throw_damaged_deflate();
        for (bool is_last = false; !is_last;) {
            is_last = number(1) == 1;
            read_block(number(2));
        }
        if (filled_ != contents_.size())
            throw ImageError("ends too early");
        bits_.skip_to_byte();
        std::uint32_t sum = 0;
        for (int byte = 0; byte < 4; ++byte)
            sum = sum << 8 | number(8);
        if (sum != adler32({reinterpret_cast<const char*>(contents_.data()), contents_.size()}))
            throw_damaged_deflate();
        return std::move(contents_);
    }

private:
    void read_block(std::uint32_t type)
    {
        if (type == 0)
            copy_stored();
        else if (type == 1)
            read_fixed_block();
        else if (type == 2)
            read_dynamic_block();
        else
            throw_damaged_deflate();
    }

    void copy_stored()
    {
        bits_.skip_to_byte();
        const std::uint32_t size = number(16);
        if (number(16) != (size ^ 0xffffu))
            throw_damaged_deflate();
        require_room(size);
        for (const std::size_t end = filled_ + size; filled_ < end;)
            contents_[filled_++] = static_cast<std::uint8_t>(number(8));
    }

    void read_fixed_block()
    {
        std::array<std::uint8_t, 288> lengths = {};
        std::fill_n(lengths.begin(), 144, std::uint8_t{8});
        std::fill_n(lengths.begin() + 144, 112, std::uint8_t{9});
        std::fill_n(lengths.begin() + 256, 24, std::uint8_t{7});
        std::fill_n(lengths.begin() + 280, 8, std::uint8_t{8});
        std::array<std::uint8_t, 30> distance_lengths = {};
        distance_lengths.fill(5);
        read_symbols(deflate_code(lengths.data(), lengths.size()),
                     deflate_code(distance_lengths.data(), distance_lengths.size()));
    }

    /// Reads a block that begins with its own two codes, given by lengths that are themselves coded (RFC 1951, 3.2.7).
    void read_dynamic_block()
    {
        const std::size_t literals = number(5) + 257;
        const std::size_t distances = number(5) + 1;
        const std::size_t length_codes = number(4) + 4;
        if (literals > 286)
            throw_damaged_deflate();

        constexpr std::uint8_t order[19] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
        std::array<std::uint8_t, 19> lengths_of_lengths = {};
        for (std::size_t i = 0; i < length_codes; ++i)
            lengths_of_lengths[order[i]] = static_cast<std::uint8_t>(number(3));
        const PrefixCode length_code = deflate_code(lengths_of_lengths.data(), lengths_of_lengths.size());

        std::array<std::uint8_t, 286 + 32> lengths = {};
        for (std::size_t i = 0; i < literals + distances;) {
            const std::uint32_t symbol = length_code.symbol(bits_);
            std::size_t repeats = 1;
            auto length = static_cast<std::uint8_t>(symbol);
            if (symbol == 16) {
                if (i == 0)
                    throw_damaged_deflate();
                length = lengths[i - 1];
                repeats = 3 + number(2);
            } else if (symbol > 16) {
                length = 0;
                repeats = symbol == 17 ? 3 + number(3) : 11 + number(7);
            }
            if (repeats > literals + distances - i)
                throw_damaged_deflate();
            for (; repeats > 0; --repeats)
                lengths[i++] = length;
        }
        read_symbols(deflate_code(lengths.data(), literals), deflate_code(lengths.data() + literals, distances));
    }

    void read_symbols(const PrefixCode& literal_code, const PrefixCode& distance_code)
    {
        constexpr std::uint32_t end_of_block = 256;
        for (;;) {
            const std::uint32_t symbol = literal_code.symbol(bits_);
            if (symbol < end_of_block) {
                require_room(1);
                contents_[filled_++] = static_cast<std::uint8_t>(symbol);
            } else if (symbol == end_of_block) {
                return;
            } else {
                copy_match(symbol - 257, distance_code);
            }
        }
    }

    void copy_match(std::uint32_t length_symbol, const PrefixCode& distance_code)
    {
        constexpr std::uint32_t longest = 28;
        if (length_symbol > longest)
            throw_damaged_deflate();
        const std::size_t length = length_symbol == longest ? 258 : 3 + doubling_number(length_symbol, 4);
        const std::uint32_t distance_symbol = distance_code.symbol(bits_);
        if (distance_symbol > 29)
            throw_damaged_deflate();
        const std::size_t distance = 1 + doubling_number(distance_symbol, 2);
        if (distance > filled_)
            throw_damaged_deflate();
        require_room(length);
        std::uint8_t* const to = contents_.data() + filled_;
        if (distance >= length)
            std::memcpy(to, to - distance, length);
        else
            for (std::size_t i = 0; i < length; ++i) // the match overlaps its own copy
                to[i] = (to - distance)[i];
        filled_ += length;
    }

    /// The value of a length or distance symbol, counted from zero: its range, and the place in it by extra bits.
    /// Ranges double in size every `per_size` symbols (RFC 1951, 3.2.5).
    std::size_t doubling_number(std::uint32_t symbol, std::uint32_t per_size)
    {
        if (symbol < 2 * per_size)
            return symbol;
        const std::uint32_t extra = symbol / per_size - 1;
        return ((per_size + symbol % per_size) << extra) + number(extra);
    }

    /// Reads a number of at most 16 bits, the lowest one first.
    std::uint32_t number(unsigned count)
    {
        const unsigned reversed = bits_.take(count) << (16 - count);
        return std::uint32_t{reversed_byte[reversed & 255]} << 8 | reversed_byte[reversed >> 8];
    }

    void require_room(std::size_t count) const
    {
        if (count > contents_.size() - filled_)
            throw_damaged_deflate();
    }

    BitReader bits_;
    std::vector<std::uint8_t> contents_;
    std::size_t filled_ = 0;
};

} // namespace

std::vector<std::uint8_t> inflate(std::string_view stream, std::size_t size)
{
    constexpr std::size_t best_ratio = 1032; // a match of 258 bytes takes at least two bits
    if (size / best_ratio > stream.size())
        throw ImageError("ends too early");
    return Inflater(stream, size).contents();
}

} // namespace multipath
