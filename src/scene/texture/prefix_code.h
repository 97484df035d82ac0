#pragma once

#include "base/errors.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace multipath {

/// Reads the bits of some bytes in order, from the highest to the lowest bit of each byte.
class BitReader
{
public:
    explicit BitReader(std::string bytes) : bytes_(std::move(bytes)) {}

    /// The next `count` <= 16 bits as a number, with zeros after the end.
    unsigned peek(unsigned count)
    {
        if (valid_ < count)
            refill();
        return static_cast<unsigned>(buffer_ >> (valid_ - count)) & ((1u << count) - 1);
    }

    /// Skips bits that peek() has shown. Throws ImageError if they lie after the end.
    void skip(unsigned count)
    {
        valid_ -= count;
        if (valid_ < padding_)
            throw ImageError("ends too early");
    }

    unsigned take(unsigned count)
    {
        const unsigned number = peek(count);
        skip(count);
        return number;
    }

    void skip_to_byte() { skip(valid_ % 8); }

private:
    void refill()
    {
        for (; valid_ <= 48; valid_ += 8) {
            const bool is_end = next_ == bytes_.size();
            buffer_ = buffer_ << 8 | (is_end ? 0u : static_cast<unsigned char>(bytes_[next_++]));
            padding_ += is_end ? 8 : 0;
        }
    }

    std::string bytes_;
    std::size_t next_ = 0;
    std::uint64_t buffer_ = 0;
    unsigned valid_ = 0;   ///< number of valid bits, the lowest ones of the buffer
    unsigned padding_ = 0; ///< number of zeros that were put into the buffer after the end
};

/// Canonical prefix code, as in Huffman coding: code words of up to 16 bits, where those of one length are consecutive
/// numbers, and longer ones follow shorter ones.
class PrefixCode
{
public:
    using Counts = std::array<unsigned, 17>; ///< number of code words of each length [bits]

    PrefixCode() = default; ///< no code words

    /// `symbols`: those of all code words in their order, below 4096. Throws ImageError if there are more code words of
    /// a length than numbers.
    PrefixCode(const Counts& counts, std::vector<std::uint16_t> symbols);

    bool empty() const { return symbols_.empty(); }

    /// Reads a code word and returns its symbol. Throws ImageError if there is no such code word.
    unsigned symbol(BitReader& bits) const
    {
        const unsigned ahead = bits.peek(16);
        if (const unsigned entry = short_words_[ahead >> (16 - short_bits)]; entry != 0) {
            bits.skip(entry & 15);
            return entry >> 4;
        }
        for (unsigned length = short_bits + 1; length < limit_.size(); ++length)
            if (ahead < limit_[length]) {
                bits.skip(length);
                return symbols_[(ahead >> (16 - length)) + offset_[length]];
            }
        bits.skip(16);
        throw ImageError("has damaged pixel data");
    }

private:
    static constexpr unsigned short_bits = 10; ///< a table has the code words of up to so many bits
    std::vector<std::uint16_t> symbols_;
    std::array<unsigned, 17> limit_ = {};  ///< by length: the first 16-bit number above its code words, aligned left
    std::array<unsigned, 17> offset_ = {}; ///< by length: index of the symbol minus code word, modulo 2^32
    std::array<std::uint16_t, 1u << short_bits> short_words_ = {}; ///< 16 symbol + length; 0: a longer code word
};

} // namespace multipath
