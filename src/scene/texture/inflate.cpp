// Decompression of a deflate stream (RFC 1951) in the zlib format (RFC 1950). A stream is a list of blocks, each stored
// or coded with two prefix codes: one for literal bytes and the lengths of matches, one for the distances of matches.

#include "base/errors.h"
#include "scene/texture/byte_reader.h"

#include "scene/texture/image_formats.h"

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

/// Reads the bits of a stream, from the lowest to the highest of each byte.
class DeflateBits
{
public:
    explicit DeflateBits(std::string_view bytes) : bytes_(bytes) {}

    /// At least the next 57 bits, with zeros after the end of the stream.
    std::uint64_t peek()
    {
        while (count_ <= 56 && next_ < bytes_.size()) {
            bits_ |= std::uint64_t{static_cast<std::uint8_t>(bytes_[next_++])} << count_;
            count_ += 8;
        }
        return bits_;
    }

    void drop(unsigned count)
    {
        if (count > count_)
            throw ImageError("ends too early");
        bits_ >>= count;
        count_ -= count;
    }

    /// Reads a number of at most 16 bits.
    std::uint32_t take(unsigned count)
    {
        const std::uint64_t mask = (std::uint64_t{1} << count) - 1;
        const auto value = static_cast<std::uint32_t>(peek() & mask);
        drop(count);
        return value;
    }

    void drop_to_byte() { drop(count_ % 8); }

    /// Reads whole bytes, after drop_to_byte().
    std::string_view take_bytes(std::size_t count)
    {
        next_ -= count_ / 8;
        bits_ = 0;
        count_ = 0;
        if (count > bytes_.size() - next_)
            throw ImageError("ends too early");
        next_ += count;
        return bytes_.substr(next_ - count, count);
    }

private:
    std::string_view bytes_;
    std::size_t next_ = 0;
    std::uint64_t bits_ = 0;
    unsigned count_ = 0; ///< valid bits of bits_
};

/// A canonical prefix code (RFC 1951, 3.2.2), given by the lengths of its code words; length 0 means that a symbol is
/// not used. Code words of up to 10 bits are looked up in a table by the next bits of the stream. Longer ones are
/// decoded bit by bit: the code words of one length are consecutive numbers.
class DeflateCode
{
public:
    DeflateCode(const std::uint8_t* lengths, std::size_t symbols)
    {
        for (std::size_t symbol = 0; symbol < symbols; ++symbol)
            ++used_[lengths[symbol]];
        used_[0] = 0;
        std::array<std::uint32_t, longest + 1> next = {};
        std::uint32_t code = 0;
        std::uint32_t index = 0;
        for (unsigned length = 1; length <= longest; ++length) {
            code = (code + used_[length - 1]) << 1;
            if (code + used_[length] > 1u << length)
                throw_damaged_deflate();
            first_code_[length] = next[length] = code;
            first_index_[length] = index;
            index += used_[length];
        }
        for (std::size_t symbol = 0; symbol < symbols; ++symbol)
            if (const unsigned length = lengths[symbol]; length > 0)
                add(static_cast<std::uint16_t>(symbol), length, next[length]++);
    }

    std::uint32_t decode(DeflateBits& bits) const
    {
        const std::uint64_t ahead = bits.peek();
        if (const std::uint16_t entry = table_[ahead & (table_.size() - 1)]; entry != 0) {
            bits.drop(entry & 15u);
            return entry >> 4;
        }
        std::uint32_t code = 0;
        for (unsigned length = 1; length <= longest; ++length) {
            code = code << 1 | (ahead >> (length - 1) & 1);
            if (code - first_code_[length] < used_[length]) { // wraps to a large number below the first code
                bits.drop(length);
                return sorted_[first_index_[length] + code - first_code_[length]];
            }
        }
        throw_damaged_deflate();
    }

private:
    static constexpr unsigned longest = 15;
    static constexpr unsigned table_bits = 10;

    void add(std::uint16_t symbol, unsigned length, std::uint32_t code)
    {
        sorted_[first_index_[length] + code - first_code_[length]] = symbol;
        if (length > table_bits)
            return;
        std::uint32_t reversed = 0; // in the stream the highest bit of a code word comes first
        for (unsigned bit = 0; bit < length; ++bit)
            reversed |= (code >> bit & 1) << (length - 1 - bit);
        for (std::uint32_t i = reversed; i < table_.size(); i += 1u << length)
            table_[i] = static_cast<std::uint16_t>(unsigned{symbol} << 4 | length);
    }

    std::array<std::uint32_t, longest + 1> used_ = {};        ///< code words of each length
    std::array<std::uint32_t, longest + 1> first_code_ = {};  ///< of each length
    std::array<std::uint32_t, longest + 1> first_index_ = {}; ///< into sorted_
    std::array<std::uint16_t, 288> sorted_ = {};              ///< symbols in order of their code words
    std::array<std::uint16_t, 1u << table_bits> table_ = {};  ///< 16 symbol + length; 0: long or unused
};

/// The value of a length or distance symbol (RFC 1951, 3.2.5): base + a number of `extra` bits.
struct DeflateRange
{
    std::uint16_t base;
    std::uint8_t extra;
};

constexpr DeflateRange deflate_lengths[29] = {
    {3, 0},  {4, 0},  {5, 0},  {6, 0},   {7, 0},   {8, 0},   {9, 0},   {10, 0},  {11, 1}, {13, 1},
    {15, 1}, {17, 1}, {19, 2}, {23, 2},  {27, 2},  {31, 2},  {35, 3},  {43, 3},  {51, 3}, {59, 3},
    {67, 4}, {83, 4}, {99, 4}, {115, 4}, {131, 5}, {163, 5}, {195, 5}, {227, 5}, {258, 0}};

constexpr DeflateRange deflate_distances[30] = {
    {1, 0},     {2, 0},     {3, 0},     {4, 0},      {5, 1},      {7, 1},     {9, 2},     {13, 2},
    {17, 3},    {25, 3},    {33, 4},    {49, 4},     {65, 5},     {97, 5},    {129, 6},   {193, 6},
    {257, 7},   {385, 7},   {513, 8},   {769, 8},    {1025, 9},   {1537, 9},  {2049, 10}, {3073, 10},
    {4097, 11}, {6145, 11}, {8193, 12}, {12289, 12}, {16385, 13}, {24577, 13}};

class Inflater
{
public:
    Inflater(std::string_view stream, std::size_t size) : bits_(stream), contents_(size) {}

    std::vector<std::uint8_t> contents()
    {
        const std::uint32_t method = bits_.take(8);
        const std::uint32_t flags = bits_.take(8);
        const bool has_dictionary = (flags & 0x20) != 0;
        if ((method & 15) != 8 || (256 * method + flags) % 31 != 0 || has_dictionary)
            throw_damaged_deflate();
        for (bool is_last = false; !is_last;) {
            is_last = bits_.take(1) == 1;
            read_block(bits_.take(2));
        }
        if (filled_ != contents_.size())
            throw ImageError("ends too early");
        bits_.drop_to_byte();
        std::uint32_t sum = 0;
        for (int byte = 0; byte < 4; ++byte)
            sum = sum << 8 | bits_.take(8);
        if (sum != adler_32())
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
        bits_.drop_to_byte();
        const std::uint32_t size = bits_.take(16);
        if (bits_.take(16) != (size ^ 0xffffu))
            throw_damaged_deflate();
        require_room(size);
        const std::string_view bytes = bits_.take_bytes(size);
        std::copy(bytes.begin(), bytes.end(), contents_.begin() + static_cast<std::ptrdiff_t>(filled_));
        filled_ += size;
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
        read_symbols({lengths.data(), lengths.size()}, {distance_lengths.data(), distance_lengths.size()});
    }

    /// Reads a block that begins with its own two codes, given by lengths that are themselves coded (RFC 1951, 3.2.7).
    void read_dynamic_block()
    {
        const std::size_t literals = bits_.take(5) + 257;
        const std::size_t distances = bits_.take(5) + 1;
        const std::size_t length_codes = bits_.take(4) + 4;
        if (literals > 286)
            throw_damaged_deflate();

        constexpr std::uint8_t order[19] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
        std::array<std::uint8_t, 19> lengths_of_lengths = {};
        for (std::size_t i = 0; i < length_codes; ++i)
            lengths_of_lengths[order[i]] = static_cast<std::uint8_t>(bits_.take(3));
        const DeflateCode length_code(lengths_of_lengths.data(), lengths_of_lengths.size());

        std::array<std::uint8_t, 286 + 32> lengths = {};
        for (std::size_t i = 0; i < literals + distances;) {
            const std::uint32_t symbol = length_code.decode(bits_);
            std::size_t repeats = 1;
            auto length = static_cast<std::uint8_t>(symbol);
            if (symbol == 16) {
                if (i == 0)
                    throw_damaged_deflate();
                length = lengths[i - 1];
                repeats = 3 + bits_.take(2);
            } else if (symbol > 16) {
                length = 0;
                repeats = symbol == 17 ? 3 + bits_.take(3) : 11 + bits_.take(7);
            }
            if (repeats > literals + distances - i)
                throw_damaged_deflate();
            for (; repeats > 0; --repeats)
                lengths[i++] = length;
        }
        read_symbols({lengths.data(), literals}, {lengths.data() + literals, distances});
    }

    void read_symbols(const DeflateCode& literal_code, const DeflateCode& distance_code)
    {
        constexpr std::uint32_t end_of_block = 256;
        for (;;) {
            const std::uint32_t symbol = literal_code.decode(bits_);
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

    void copy_match(std::uint32_t length_symbol, const DeflateCode& distance_code)
    {
        if (length_symbol >= std::size(deflate_lengths))
            throw_damaged_deflate();
        const std::size_t length = number(deflate_lengths[length_symbol]);
        const std::uint32_t distance_symbol = distance_code.decode(bits_);
        if (distance_symbol >= std::size(deflate_distances))
            throw_damaged_deflate();
        const std::size_t distance = number(deflate_distances[distance_symbol]);
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

    std::size_t number(DeflateRange range) { return range.base + bits_.take(range.extra); }

    void require_room(std::size_t count) const
    {
        if (count > contents_.size() - filled_)
            throw_damaged_deflate();
    }

    std::uint32_t adler_32() const
    {
        constexpr std::size_t sums_fit = 5552; // bytes before the second sum could exceed 32 bits
        std::uint32_t a = 1;
        std::uint32_t b = 0;
        for (std::size_t first = 0; first < contents_.size(); first += sums_fit) {
            const std::size_t last = std::min(first + sums_fit, contents_.size());
            for (std::size_t i = first; i < last; ++i) {
                a += contents_[i];
                b += a;
            }
            a %= 65521;
            b %= 65521;
        }
        return b << 16 | a;
    }

    DeflateBits bits_;
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
