#include "scene/texture/prefix_code.h"

#include <algorithm>

namespace multipath {

PrefixCode::PrefixCode(const Counts& counts, std::vector<std::uint16_t> symbols) : symbols_(std::move(symbols))
{
    unsigned word = 0;
    unsigned index = 0;
    for (unsigned length = 1; length < counts.size(); ++length, word <<= 1) {
        if (word + counts[length] > 1u << length)
            throw ImageError("has damaged pixel data");
        offset_[length] = index - word;
        for (unsigned end = word + counts[length]; word < end; ++word, ++index)
            if (length <= short_bits)
                std::fill_n(&short_words_[word << (short_bits - length)], 1u << (short_bits - length),
                            static_cast<std::uint16_t>(unsigned{symbols_[index]} << 4 | length));
        limit_[length] = word << (16 - length);
    }
}

} // namespace multipath
