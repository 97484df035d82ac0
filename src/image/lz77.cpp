// Copies are found through chains of earlier places that start with the same three bytes (up to a hash collision). A
// copy is taken only if the next place does not offer a longer one (lazy matching, RFC 1951, section 4).

#include "image/lz77.h"

#include <algorithm>

namespace multipath {

namespace {

constexpr std::size_t window = 32768;
constexpr std::size_t shortest_copy = 3;
constexpr std::size_t longest_copy = 258;
constexpr std::size_t hash_bits = 15;
constexpr std::uint32_t no_place = 0xffffffffu;

// What effort is worth its time on pictures.
constexpr int chain_limit = 128;            // earlier places looked at
constexpr std::size_t good_already = 8;     // a copy in hand that makes a quarter of them enough
constexpr std::size_t good_enough = 128;    // a copy that ends the search
constexpr std::size_t not_worth_delay = 16; // a copy that is taken without looking at the next place
constexpr std::size_t far = 4096;           // a copy of three bytes from farther away costs more bits than literals

struct Copy
{
    std::size_t length = 0;
    std::size_t distance = 0;
};

/// The places seen so far, findable by their first three bytes.
class Places
{
public:
    explicit Places(const std::string& bytes)
        : bytes_(bytes), newest_(std::size_t{1} << hash_bits, no_place), older_(window)
    {
    }

    void add(std::size_t place)
    {
        if (place + shortest_copy > bytes_.size())
            return;
        std::uint32_t& newest = newest_[hash(place)];
        older_[place % window] = newest;
        newest = static_cast<std::uint32_t>(place);
    }

    /// The longest copy for what starts at `place` that is longer than `at_least`; length 0 if there is none.
    Copy longest(std::size_t place, std::size_t at_least) const
    {
        const std::size_t limit = std::min(longest_copy, bytes_.size() - place);
        if (limit < shortest_copy)
            return {};
        Copy best;
        std::size_t to_beat = std::max(at_least, shortest_copy - 1);
        const int steps = at_least >= good_already ? chain_limit / 4 : chain_limit;
        std::uint32_t earlier = newest_[hash(place)];
        for (int step = 0; step < steps && earlier != no_place && to_beat < limit; ++step) {
            const std::size_t distance = place - earlier;
            if (distance > window)
                break;
            const std::size_t length = common_length(earlier, place, limit, to_beat);
            if (length > to_beat && !(length == shortest_copy && distance > far)) {
                best = {length, distance};
                to_beat = length;
                if (length >= good_enough)
                    break;
            }
            earlier = older_[earlier % window];
        }
        return best;
    }

private:
    std::size_t hash(std::size_t place) const
    {
        const auto byte = [&](std::size_t n) { return std::uint32_t{static_cast<unsigned char>(bytes_[place + n])}; };
        return (byte(0) | byte(1) << 8 | byte(2) << 16) * 0x9e3779b1u >> (32 - hash_bits);
    }

    /// How many bytes agree, or 0 if not more than `to_beat`: most candidates fail at the byte that would beat it.
    std::size_t common_length(std::size_t a, std::size_t b, std::size_t limit, std::size_t to_beat) const
    {
        if (bytes_[a + to_beat] != bytes_[b + to_beat] || bytes_[a] != bytes_[b])
            return 0;
        std::size_t length = 0;
        while (length < limit && bytes_[a + length] == bytes_[b + length])
            ++length;
        return length;
    }

    const std::string& bytes_;
    std::vector<std::uint32_t> newest_; ///< per hash
    std::vector<std::uint32_t> older_;  ///< per place modulo the window: the place before it with the same hash
};

} // namespace

std::vector<Token> lz77_tokens(const std::string& bytes)
{
    std::vector<Token> tokens;
    Places places(bytes);
    Copy copy;
    for (std::size_t place = 0; place < bytes.size();) {
        places.add(place);
        const Copy next = copy.length < not_worth_delay ? places.longest(place + 1, copy.length) : Copy{};
        if (copy.length == 0 || next.length > 0) {
            tokens.push_back({0, static_cast<unsigned char>(bytes[place])});
            copy = next;
            ++place;
            continue;
        }
        tokens.push_back({static_cast<std::uint16_t>(copy.length), static_cast<std::uint16_t>(copy.distance)});
        const std::size_t end = place + copy.length;
        while (++place < end)
            places.add(place);
        copy = places.longest(place, 0);
    }
    return tokens;
}

} // namespace multipath
