#include "base/checksum.h"

#include <array>

namespace multipath {

namespace {

/// The CRC remainder of each byte followed by four zero bytes.
constexpr std::array<std::uint32_t, 256> make_crc_table()
{
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t remainder = byte;
        for (int bit = 0; bit < 8; ++bit)
            remainder = (remainder >> 1) ^ ((remainder & 1u) != 0 ? 0xedb88320u : 0u);
        table[byte] = remainder;
    }
    return table;
}

constexpr std::array<std::uint32_t, 256> crc_table = make_crc_table();

} // namespace

std::uint32_t crc32(std::string_view bytes)
{
    std::uint32_t crc = 0xffffffffu;
    for (const char c : bytes)
        crc = crc_table[(crc ^ static_cast<unsigned char>(c)) & 0xffu] ^ (crc >> 8);
    return crc ^ 0xffffffffu;
}

std::uint32_t adler32(std::string_view bytes)
{
    constexpr std::uint64_t modulus = 65521;
    constexpr std::size_t sums_fit = std::size_t{1} << 20; // bytes before the second sum could exceed 64 bits
    std::uint64_t sum = 1;
    std::uint64_t sum_of_sums = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        sum += static_cast<unsigned char>(bytes[i]);
        sum_of_sums += sum;
        if (i % sums_fit == 0) {
            sum %= modulus;
            sum_of_sums %= modulus;
        }
    }
    return static_cast<std::uint32_t>(sum_of_sums % modulus << 16 | sum % modulus);
}

} // namespace multipath
