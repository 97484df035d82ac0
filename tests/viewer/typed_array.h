#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace multipath {

/// A plain decoder of base64 (RFC 4648), one digit at a time.
inline std::string base64_decoded(const std::string& text)
{
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=')
            break;
        bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes += static_cast<char>(static_cast<unsigned char>(bits >> count & 255u));
        }
    }
    return bytes;
}

inline std::vector<std::uint32_t> uint32_array(const std::string& text)
{
    const std::string bytes = base64_decoded(text);
    std::vector<std::uint32_t> words(bytes.size() / 4);
    for (std::size_t k = 0; k < 4 * words.size(); ++k)
        words[k / 4] |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[k])) << 8 * (k % 4);
    return words;
}

inline std::vector<float> float32_array(const std::string& text)
{
    std::vector<float> numbers;
    for (const std::uint32_t word : uint32_array(text)) {
        float number = 0.0f;
        std::memcpy(&number, &word, sizeof number);
        numbers.push_back(number);
    }
    return numbers;
}

/// Floating-point numbers of 16 bits (IEEE 754) that are not negative.
inline std::vector<double> float16_array(const std::string& text)
{
    const std::string bytes = base64_decoded(text);
    std::vector<double> numbers;
    for (std::size_t k = 0; k + 1 < bytes.size(); k += 2) {
        const int bits = static_cast<unsigned char>(bytes[k]) | static_cast<unsigned char>(bytes[k + 1]) << 8;
        const int exponent = bits >> 10;
        const int digits = bits & 1023;
        numbers.push_back(exponent == 0 ? std::ldexp(digits, -24) : std::ldexp(1024 + digits, exponent - 25));
    }
    return numbers;
}

} // namespace multipath
