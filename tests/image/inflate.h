#pragma once

// A plain reader of deflate streams, written apart from the writer so that the two check each other. Slow and short:
// one bit at a time, codes decoded by counting (RFC 1951, sections 3.2.2 and 3.2.7).

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace multipath {

class Inflater
{
public:
    explicit Inflater(const std::string& bytes) : bytes_(bytes) {}

    /// The original bytes. Throws std::runtime_error for anything that is not a well-formed stream to its last byte.
    std::string original()
    {
        bool final = false;
        while (!final) {
            final = bits(1) == 1;
            if (bits(2) != 2)
                throw std::runtime_error("only dynamic blocks are expected");
            read_block();
        }
        if (position_ / 8 + (position_ % 8 != 0 ? 1 : 0) != bytes_.size())
            throw std::runtime_error("bytes left over");
        return result_;
    }

private:
    using Lengths = std::vector<unsigned>;

    unsigned bits(int count)
    {
        unsigned value = 0;
        for (int i = 0; i < count; ++i, ++position_) {
            if (position_ / 8 >= bytes_.size())
                throw std::runtime_error("cut off");
            value |= (static_cast<unsigned char>(bytes_[position_ / 8]) >> (position_ % 8) & 1u) << i;
        }
        return value;
    }

    /// Words of one length are consecutive numbers, in the order of their symbols.
    unsigned symbol(const Lengths& lengths)
    {
        unsigned word = 0;
        unsigned first = 0;
        for (unsigned length = 1; length <= 15; ++length) {
            word = word << 1 | bits(1);
            first <<= 1;
            for (unsigned s = 0; s < lengths.size(); ++s)
                if (lengths[s] == length && word == first++)
                    return s;
        }
        throw std::runtime_error("no such code word");
    }

    /// Lengths of `count` code words, runs written out.
    Lengths code(const Lengths& header, std::size_t count)
    {
        Lengths lengths;
        while (lengths.size() < count) {
            const unsigned s = symbol(header);
            if (s < 16)
                lengths.push_back(s);
            else if (s == 16)
                lengths.insert(lengths.end(), 3 + bits(2), lengths.at(lengths.size() - 1));
            else
                lengths.insert(lengths.end(), s == 17 ? 3 + bits(3) : 11 + bits(7), 0u);
        }
        if (lengths.size() != count)
            throw std::runtime_error("a run leads past the codes");
        return lengths;
    }

    void read_block()
    {
        const std::size_t literal_count = 257 + bits(5);
        const std::size_t distance_count = 1 + bits(5);
        const unsigned header_count = 4 + bits(4);
        const unsigned order[19] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
        Lengths header(19, 0);
        for (unsigned i = 0; i < header_count; ++i)
            header[order[i]] = bits(3);
        const Lengths lengths = code(header, literal_count + distance_count);
        const auto border = lengths.begin() + static_cast<std::ptrdiff_t>(literal_count);
        read_data({lengths.begin(), border}, {border, lengths.end()});
    }

    void read_data(const Lengths& literals, const Lengths& distances)
    {
        const unsigned length_base[29] = {3,  4,  5,  6,  7,  8,  9,  10, 11,  13,  15,  17,  19,  23, 27,
                                          31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258};
        const int length_extra[29] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                      2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
        const unsigned distance_base[30] = {1,    2,    3,    4,    5,    7,    9,    13,    17,    25,
                                            33,   49,   65,   97,   129,  193,  257,  385,   513,   769,
                                            1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
        for (unsigned s = symbol(literals); s != 256; s = symbol(literals)) {
            if (s < 256) {
                result_ += static_cast<char>(s);
                continue;
            }
            const unsigned length = length_base[s - 257] + bits(length_extra[s - 257]);
            const unsigned d = symbol(distances);
            const unsigned distance = distance_base[d] + bits(d < 4 ? 0 : static_cast<int>(d) / 2 - 1);
            if (distance > result_.size())
                throw std::runtime_error("copy from before the start");
            for (unsigned i = 0; i < length; ++i)
                result_ += result_[result_.size() - distance];
        }
    }

    const std::string& bytes_;
    std::size_t position_ = 0; // in bits
    std::string result_;
};

inline std::string inflate(const std::string& bytes)
{
    return Inflater(bytes).original();
}

} // namespace multipath
