// JPEG reader after ITU-T T.81 (1992), whose section numbers are given below, and JFIF 1.02 for the colours.
//
// A file is a list of marker segments: tables, one frame header and one or more scans. A scan holds the Huffman coded
// coefficients of the 8 x 8 blocks of some components. In the sequential modes a scan has complete blocks, which are
// transformed at once. In the progressive mode it has a band of frequencies, or one more bit of their coefficients, so
// the coefficients are stored and transformed after the last scan. Components of reduced resolution are then
// interpolated and the colours converted.
//
// Inverse DCT: Loeffler, Ligtenberg and Moschytz, "Practical fast 1-D DCT algorithms with 11 multiplications", 1989,
// with 13 fractional bits in the constants and 2 in the intermediate result. Transform, interpolation and colours round
// like libjpeg's default ("islow", "fancy upsampling"), so both decoders agree in every pixel of a sound file.
//
// Bytes between segments, the numbers of restart markers and a missing end marker of a sequential file are ignored. Any
// other violation of the standard is an error.

#include "base/errors.h"
#include "base/lists.h"
#include "scene/texture/byte_reader.h"
#include "scene/texture/image_formats.h"
#include "scene/texture/prefix_code.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace multipath {

namespace {

/// Limit of the blocks visited by all scans together: twenty complete scans of three components of 2^26 pixels.
constexpr std::size_t jpeg_max_block_visits = std::size_t{1} << 26;
constexpr std::size_t jpeg_least_visits = jpeg_max_block_visits / 256; ///< that a scan counts for: at most 256 scans

/// Position in the block, row by row, of the k-th coefficient of the file (figure A.6).
constexpr std::array<std::uint8_t, 64> jpeg_zigzag = {0,  1,  8,  16, 9,  2,  3,  10, 17, 24, 32, 25, 18, 11, 4,  5,
                                                      12, 19, 26, 33, 40, 48, 41, 34, 27, 20, 13, 6,  7,  14, 21, 28,
                                                      35, 42, 49, 56, 57, 50, 43, 36, 29, 22, 15, 23, 30, 37, 44, 51,
                                                      58, 59, 52, 45, 38, 31, 39, 46, 53, 60, 61, 54, 47, 55, 62, 63};

std::uint8_t jpeg_byte_at(std::string_view bytes, std::size_t position)
{
    return static_cast<std::uint8_t>(bytes[position]);
}

std::uint8_t jpeg_clamp(std::int64_t value)
{
    return static_cast<std::uint8_t>(std::clamp<std::int64_t>(value, 0, 255));
}

bool is_jpeg_restart(std::uint8_t marker)
{
    return marker >= 0xD0 && marker <= 0xD7;
}

/// The next marker at or after `position`, which is moved past it; other bytes and fill bytes are skipped.
std::optional<std::uint8_t> next_jpeg_marker(std::string_view bytes, std::size_t& position)
{
    while (position + 1 < bytes.size()) {
        const std::uint8_t code = jpeg_byte_at(bytes, position + 1);
        if (jpeg_byte_at(bytes, position++) == 0xFF && code != 0 && code != 0xFF) {
            ++position;
            return code;
        }
    }
    return std::nullopt;
}

PrefixCode read_jpeg_huffman(ByteReader& segment)
{
    constexpr std::size_t most_symbols = 256;
    PrefixCode::Counts counts = {};
    std::size_t symbol_count = 0;
    for (std::size_t length = 1; length < counts.size(); ++length)
        symbol_count += counts[length] = segment.byte();
    if (symbol_count > most_symbols)
        throw ImageError("a Huffman table is damaged");
    const std::uint8_t* const symbols = segment.bytes(symbol_count);
    return {counts, {symbols, symbols + symbol_count}};
}

/// The entropy coded data that begin at `position`, which is moved to their end: a marker or the end of the file. The
/// zeros that follow bytes 0xFF are left out (F.1.2.3).
std::string jpeg_coded_data(std::string_view bytes, std::size_t& position)
{
    std::string data;
    for (;;) {
        const std::size_t end = std::min(bytes.find('\xFF', position), bytes.size());
        data += bytes.substr(position, end - position);
        position = end;
        if (end + 1 >= bytes.size() || bytes[end + 1] != 0)
            return data;
        data += '\xFF';
        position += 2;
    }
}

using JpegBlock = std::array<std::int16_t, 64>;

struct JpegComponent
{
    std::uint8_t id = 0;
    std::uint32_t h = 1; ///< sampling factors
    std::uint32_t v = 1;
    std::size_t quantization_index = 0;
    std::uint32_t width = 0; ///< [samples]
    std::uint32_t height = 0;
    std::uint32_t blocks_x = 0; ///< without blocks that only pad the last MCU
    std::uint32_t blocks_y = 0;
    std::size_t block_count() const { return std::size_t{blocks_x} * blocks_y; }
    std::size_t stride() const { return std::size_t{8} * blocks_x; } ///< [samples]

    std::optional<std::array<std::uint16_t, 64>> quantization; ///< table at its first scan
    std::vector<JpegBlock> coefficients;                       ///< progressive mode only
    std::vector<std::uint8_t> samples;                         ///< rows of stride()
    const PrefixCode* dc = nullptr;                            ///< tables of the current scan
    const PrefixCode* ac = nullptr;
    int dc_prediction = 0;
};

/// Scan header (B.2.3): the components and coefficients that the scan contains.
struct JpegScan
{
    std::vector<JpegComponent*> components;
    unsigned first = 0; ///< spectral selection
    unsigned last = 63;
    unsigned high = 0; ///< successive approximation
    unsigned low = 0;
};

using JpegVector = std::array<std::int64_t, 8>;

/// The one-dimensional inverse DCT times sqrt(8) 2^(13 - shift), rounded. 64 bits hold the result of the largest
/// coefficients and quantization tables.
JpegVector jpeg_inverse_dct(const JpegVector& s, int shift)
{
    constexpr auto fixed = [](double factor) { return static_cast<std::int64_t>(factor * 8192.0 + 0.5); };

    const std::int64_t rotation = (s[2] + s[6]) * fixed(0.541196100);
    const std::int64_t even_2 = rotation + s[2] * fixed(0.765366865);
    const std::int64_t even_6 = rotation - s[6] * fixed(1.847759065);
    const std::int64_t sum = (s[0] + s[4]) * fixed(1.0);
    const std::int64_t difference = (s[0] - s[4]) * fixed(1.0);
    const JpegVector even = {sum + even_2, difference + even_6, difference - even_6, sum - even_2};

    const std::int64_t common = (s[1] + s[3] + s[5] + s[7]) * fixed(1.175875602);
    const std::int64_t pair_17 = (s[1] + s[7]) * fixed(0.899976223);
    const std::int64_t pair_35 = (s[3] + s[5]) * fixed(2.562915447);
    const std::int64_t pair_37 = common - (s[3] + s[7]) * fixed(1.961570560);
    const std::int64_t pair_15 = common - (s[1] + s[5]) * fixed(0.390180644);
    const JpegVector odd = {
        s[1] * fixed(1.501321110) - pair_17 + pair_15, s[3] * fixed(3.072711026) - pair_35 + pair_37,
        s[5] * fixed(2.053119869) - pair_35 + pair_15, s[7] * fixed(0.298631336) - pair_17 + pair_37};

    const std::int64_t half = std::int64_t{1} << (shift - 1);
    JpegVector result = {};
    for (std::size_t i = 0; i < 4; ++i) {
        result[i] = (even[i] + odd[i] + half) >> shift;
        result[7 - i] = (even[i] - odd[i] + half) >> shift;
    }
    return result;
}

/// Dequantizes and transforms a block into the samples of the component's block (block_x, block_y).
void transform_jpeg_block(const JpegBlock& block, JpegComponent& component, std::size_t block_x, std::size_t block_y)
{
    const std::array<std::uint16_t, 64>& quantization = *component.quantization;
    const std::size_t stride = component.stride();
    std::uint8_t* const samples = &component.samples[8 * (block_y * stride + block_x)];
    std::array<JpegVector, 8> rows = {};
    for (std::size_t x = 0; x < 8; ++x) {
        JpegVector column = {};
        bool flat = true;
        for (std::size_t y = 0; y < 8; ++y) {
            const std::int64_t level = block[8 * y + x];
            column[y] = level * quantization[8 * y + x];
            flat = flat && (y == 0 || column[y] == 0);
        }
        if (flat)
            column.fill(column[0] * 4);
        else
            column = jpeg_inverse_dct(column, 13 - 2);
        for (std::size_t y = 0; y < 8; ++y)
            rows[y][x] = column[y];
    }
    for (std::size_t y = 0; y < 8; ++y) {
        const JpegVector row = jpeg_inverse_dct(rows[y], 13 + 2 + 3);
        for (std::size_t x = 0; x < 8; ++x)
            samples[y * stride + x] = jpeg_clamp(row[x] + 128);
    }
}

std::array<std::uint8_t, 3> jpeg_ycc_to_rgb(std::uint8_t luma, std::uint8_t blue, std::uint8_t red)
{
    constexpr auto fixed = [](double factor) { return static_cast<int>(factor * 65536.0 + 0.5); };
    constexpr int half = 1 << 15;
    const int cb = blue - 128;
    const int cr = red - 128;
    return {jpeg_clamp(luma + ((fixed(1.402) * cr + half) >> 16)),
            jpeg_clamp(luma + ((half - fixed(0.34414) * cb - fixed(0.71414) * cr) >> 16)),
            jpeg_clamp(luma + ((fixed(1.772) * cb + half) >> 16))};
}

class JpegDecoder
{
public:
    explicit JpegDecoder(std::string_view bytes) : bytes_(bytes) {}

    Bitmap decode()
    {
        if (bytes_.substr(0, 2) != "\xFF\xD8")
            throw ImageError("does not begin like a JPEG file");
        std::size_t position = 2;
        bool ended = false;
        while (const std::optional<std::uint8_t> marker = next_jpeg_marker(bytes_, position)) {
            ended = *marker == 0xD9;
            if (ended)
                break;
            if (*marker == 0x01 || *marker == 0xD8 || is_jpeg_restart(*marker))
                continue; // these have no contents
            ByteReader length(bytes_.substr(position));
            if (length.left() < 2)
                break;
            const std::size_t size = length.big_endian_16();
            if (size < 2)
                throw ImageError("a JPEG segment is damaged");
            if (size > bytes_.size() - position)
                break;
            const std::string_view segment = bytes_.substr(position + 2, size - 2);
            position += size;
            if (*marker == 0xDA)
                position = read_scan(ByteReader(segment), position);
            else
                read_segment(*marker, segment);
        }
        const auto lacks_scan = [](const JpegComponent& component) { return !component.quantization; };
        if (components_.empty() || (progressive_ && !ended) ||
            std::any_of(components_.begin(), components_.end(), lacks_scan))
            throw ImageError("ends too early");
        return convert();
    }

private:
    void read_segment(std::uint8_t marker, std::string_view contents)
    {
        ByteReader segment(contents);
        if (marker == 0xC4)
            read_huffman_tables(segment);
        else if (marker == 0xDB)
            read_quantization_tables(segment);
        else if (marker >= 0xC0 && marker <= 0xCF && marker != 0xC8 && marker != 0xCC)
            read_frame(marker, segment);
        else if (marker == 0xDD)
            restart_interval_ = segment.big_endian_16();
        else if (marker == 0xE0 && contents.substr(0, 5) == std::string_view("JFIF\0", 5))
            is_jfif_ = true;
        else if (marker == 0xEE && contents.substr(0, 5) == "Adobe" && contents.size() >= 12)
            adobe_transform_ = jpeg_byte_at(contents, 11);
    }

    void read_huffman_tables(ByteReader segment)
    {
        while (segment.left() > 0) {
            const unsigned target = segment.byte();
            if ((target & ~0x13U) != 0)
                throw ImageError("a Huffman table is damaged");
            (target < 0x10 ? dc_tables_ : ac_tables_)[target & 3] = read_jpeg_huffman(segment);
        }
    }

    void read_quantization_tables(ByteReader segment)
    {
        while (segment.left() > 0) {
            const unsigned target = segment.byte();
            if ((target & ~0x13U) != 0)
                throw ImageError("a quantization table is damaged");
            std::array<std::uint16_t, 64> table = {};
            for (const std::uint8_t index : jpeg_zigzag)
                table[index] = static_cast<std::uint16_t>(target < 0x10 ? segment.byte() : segment.big_endian_16());
            quantization_tables_[target & 3] = table;
        }
    }

    void read_frame(std::uint8_t marker, ByteReader segment)
    {
        const unsigned mode = marker - 0xC0U;
        if (mode > 2)
            throw ImageError("JPEG with arithmetic coding, lossless and hierarchical JPEG are not supported");
        if (!components_.empty())
            throw ImageError("a JPEG file with two frames is not supported");
        progressive_ = mode == 2;
        if (const unsigned precision = segment.byte(); precision != 8)
            throw ImageError("JPEG of " + std::to_string(precision) + " bits per sample is not supported");
        const std::uint32_t height = segment.big_endian_16();
        const std::uint32_t width = segment.big_endian_16();
        if (height == 0)
            throw ImageError("JPEG whose height follows the first scan (DNL) is not supported");
        require_bitmap_size(width, height);

        const unsigned count = segment.byte();
        if (count != 1 && count != 3 && count != 4)
            throw ImageError("JPEG of " + std::to_string(count) + " components is not supported");
        components_.resize(count);
        for (JpegComponent& component : components_) {
            component.id = segment.byte();
            const unsigned sampling = segment.byte();
            component.h = sampling >> 4;
            component.v = sampling & 15;
            component.quantization_index = segment.byte();
            if (component.h < 1 || component.h > 4 || component.v < 1 || component.v > 4 ||
                component.quantization_index > 3)
                throw ImageError("the JPEG frame header is damaged");
            h_max_ = std::max(h_max_, component.h);
            v_max_ = std::max(v_max_, component.v);
        }
        for (JpegComponent& component : components_) {
            component.width = (width * component.h + h_max_ - 1) / h_max_;
            component.height = (height * component.v + v_max_ - 1) / v_max_;
            component.blocks_x = (component.width + 7) / 8;
            component.blocks_y = (component.height + 7) / 8;
        }
        // A block takes at least one bit. A file with fewer than 1/16 of these bits is refused before memory is
        // allocated.
        constexpr std::size_t least_part = 16;
        const std::size_t blocks = sum_over(components_, &JpegComponent::block_count);
        if (8 * least_part * bytes_.size() < blocks)
            throw ImageError("ends too early");
        for (JpegComponent& component : components_) {
            component.samples.assign(64 * component.block_count(), 128);
            component.coefficients.resize(progressive_ ? component.block_count() : 0);
        }
        picture_ = blank_bitmap(width, height);
        picture_.is_of_inks = count == 4;
    }

    JpegScan read_scan_header(ByteReader segment)
    {
        if (components_.empty())
            throw ImageError("a JPEG scan comes before the frame header");
        JpegScan scan;
        const unsigned count = segment.byte();
        if (count < 1 || count > components_.size())
            throw ImageError("a JPEG scan header is damaged");
        for (unsigned i = 0; i < count; ++i) {
            const std::uint8_t id = segment.byte();
            const unsigned tables = segment.byte();
            const auto is_new_with_id = [&](const JpegComponent& c) {
                return c.id == id && std::count(scan.components.begin(), scan.components.end(), &c) == 0;
            };
            const auto component = std::find_if(components_.begin(), components_.end(), is_new_with_id);
            if (component == components_.end() || (tables & ~0x33U) != 0)
                throw ImageError("a JPEG scan header is damaged");
            component->dc = &dc_tables_[tables >> 4];
            component->ac = &ac_tables_[tables & 15];
            scan.components.push_back(&*component);
        }
        const unsigned first = segment.byte();
        const unsigned last = segment.byte();
        const unsigned approximation = segment.byte();
        if (progressive_) { // (G.1.1.1)
            scan.first = first;
            scan.last = last;
            scan.high = approximation >> 4;
            scan.low = approximation & 15;
            if (last > 63 || first > last || (first == 0 && last > 0) || (first > 0 && count > 1) || scan.low > 13 ||
                (scan.high != 0 && scan.high != scan.low + 1))
                throw ImageError("a progressive JPEG scan is damaged");
        }
        return scan;
    }

    /// Decodes a scan whose coded data begin at `position`; returns the position of their end.
    std::size_t read_scan(ByteReader segment, std::size_t position)
    {
        scan_ = read_scan_header(segment);
        const bool needs_dc = scan_.first == 0 && scan_.high == 0;
        const bool needs_ac = scan_.last > 0;
        for (JpegComponent* component : scan_.components) {
            if (!component->quantization)
                component->quantization = quantization_tables_[component->quantization_index];
            if (!component->quantization)
                throw ImageError("a quantization table is missing");
            if ((needs_dc && component->dc->empty()) || (needs_ac && component->ac->empty()))
                throw ImageError("a Huffman table is missing");
        }

        // In a scan of several components, an MCU has h x v blocks of each of them; in a scan of a single component, it
        // is one block (A.2).
        const bool interleaved = scan_.components.size() > 1;
        const JpegComponent& front = *scan_.components.front();
        const std::size_t mcus_x =
            interleaved ? (picture_.width + 8 * h_max_ - 1) / (8 * h_max_) : std::size_t{front.blocks_x};
        const std::size_t mcus_y =
            interleaved ? (picture_.height + 8 * v_max_ - 1) / (8 * v_max_) : std::size_t{front.blocks_y};
        std::size_t blocks_per_mcu = 0;
        for (const JpegComponent* component : scan_.components)
            blocks_per_mcu += interleaved ? component->h * component->v : 1;
        block_visits_ += std::max(mcus_x * mcus_y * blocks_per_mcu, jpeg_least_visits);
        if (block_visits_ > jpeg_max_block_visits)
            throw ImageError("the JPEG file has too many scans");

        begin_interval(position);
        for (std::size_t mcu = 0; mcu < mcus_x * mcus_y; ++mcu) {
            if (restart_interval_ != 0 && mcu != 0 && mcu % restart_interval_ == 0) {
                const std::optional<std::uint8_t> marker = next_jpeg_marker(bytes_, position);
                if (!marker || !is_jpeg_restart(*marker))
                    throw ImageError("ends too early");
                begin_interval(position);
            }
            const std::size_t mcu_x = mcu % mcus_x;
            const std::size_t mcu_y = mcu / mcus_x;
            for (JpegComponent* component : scan_.components) {
                const std::size_t h = interleaved ? component->h : 1;
                const std::size_t v = interleaved ? component->v : 1;
                for (std::size_t i = 0; i < h * v; ++i)
                    decode_block(*component, mcu_x * h + i % h, mcu_y * v + i / h);
            }
        }
        return position;
    }

    /// Begins the data up to the next restart marker, to which `position` is moved, or to the end of the scan.
    void begin_interval(std::size_t& position)
    {
        bits_ = BitReader(jpeg_coded_data(bytes_, position));
        end_of_band_run_ = 0;
        for (JpegComponent& component : components_)
            component.dc_prediction = 0;
    }

    void decode_block(JpegComponent& component, std::size_t x, std::size_t y)
    {
        // Blocks that only pad an MCU are decoded and dropped. In the progressive mode they occur only in scans of the
        // DC coefficient, whose code does not depend on earlier scans.
        const bool is_inside = x < component.blocks_x && y < component.blocks_y;
        JpegBlock block = {};
        if (progressive_)
            return decode_band(component, is_inside ? component.coefficients[y * component.blocks_x + x] : block);
        decode_dc(component, block);
        decode_ac(component, block);
        if (is_inside)
            transform_jpeg_block(block, component, x, y);
    }

    /// Decodes the coefficients of a block that a progressive scan contains (G.1.2).
    void decode_band(JpegComponent& component, JpegBlock& block)
    {
        if (scan_.first > 0)
            return scan_.high == 0 ? decode_ac(component, block) : refine_ac(component, block);
        if (scan_.high == 0)
            return decode_dc(component, block);
        if (bits_.take(1) != 0)
            block[0] = static_cast<std::int16_t>(block[0] | 1 << scan_.low);
    }

    [[noreturn]] static void throw_damaged() { throw ImageError("the coded JPEG data is damaged"); }

    /// Reads a signed number of `size` <= 15 bits (F.2.2.1, EXTEND).
    int signed_number(unsigned size)
    {
        const int number = static_cast<int>(bits_.take(size));
        const int range = 1 << size;
        return 2 * number < range ? number - range + 1 : number;
    }

    /// Decodes the DC coefficient, coded as the difference from that of the previous block (F.2.2.1).
    void decode_dc(JpegComponent& component, JpegBlock& block)
    {
        const unsigned size = component.dc->symbol(bits_);
        if (size > 15)
            throw_damaged();
        component.dc_prediction = std::clamp(component.dc_prediction + signed_number(size), -32768, 32767);
        block[0] = static_cast<std::int16_t>(component.dc_prediction * (1 << scan_.low));
    }

    /// Decodes AC coefficients, each with the run of zeros before it (F.2.2.2). In the progressive mode the end of a
    /// block may also end a run of following blocks (G.1.2.2); in the sequential modes that run is always 0.
    void decode_ac(JpegComponent& component, JpegBlock& block)
    {
        if (end_of_band_run_ > 0) {
            --end_of_band_run_;
            return;
        }
        for (unsigned k = std::max(scan_.first, 1U); k <= scan_.last; ++k) {
            const unsigned symbol = component.ac->symbol(bits_);
            const unsigned run = symbol >> 4;
            const unsigned size = symbol & 15;
            if (size == 0 && run < 15) {
                if (progressive_)
                    end_of_band_run_ = (1U << run) - 1 + bits_.take(run);
                return;
            }
            k += run;
            if (size == 0)
                continue;
            if (k > scan_.last)
                throw_damaged();
            block[jpeg_zigzag[k]] = static_cast<std::int16_t>(signed_number(size) * (1 << scan_.low));
        }
    }

    /// Decodes one more bit of the nonzero AC coefficients, mixed with new coefficients (G.1.2.3).
    void refine_ac(JpegComponent& component, JpegBlock& block)
    {
        const int step = 1 << scan_.low;
        const auto refine = [&](std::int16_t& coefficient) {
            if (bits_.take(1) != 0)
                coefficient = static_cast<std::int16_t>(coefficient + (coefficient > 0 ? step : -step));
        };
        unsigned k = scan_.first;
        for (; k <= scan_.last && end_of_band_run_ == 0; ++k) {
            const unsigned symbol = component.ac->symbol(bits_);
            const unsigned size = symbol & 15;
            unsigned run = symbol >> 4;
            if (size == 0 && run < 15) {
                end_of_band_run_ = (1U << run) + bits_.take(run);
                break;
            }
            const int fresh = size == 0 ? 0 : bits_.take(1) != 0 ? step : -step;
            for (; k <= scan_.last; ++k) { // the run counts only coefficients that are still zero
                std::int16_t& coefficient = block[jpeg_zigzag[k]];
                if (coefficient != 0)
                    refine(coefficient);
                else if (run-- == 0)
                    break;
            }
            if (k <= scan_.last)
                block[jpeg_zigzag[k]] = static_cast<std::int16_t>(fresh);
            else if (size != 0)
                throw_damaged();
        }
        if (end_of_band_run_ == 0)
            return;
        --end_of_band_run_;
        for (; k <= scan_.last; ++k)
            if (block[jpeg_zigzag[k]] != 0)
                refine(block[jpeg_zigzag[k]]);
    }

    /// Row `y` of a component in the resolution of the image. Half resolution is interpolated with weights 3/4 of the
    /// nearest sample and 1/4 of its neighbour; alternating rounding avoids a bias. For other ratios samples are
    /// repeated.
    std::vector<std::uint8_t> full_row(const JpegComponent& component, std::uint32_t y) const
    {
        const std::size_t stride = component.stride();
        const std::uint8_t* near = &component.samples[stride * (std::size_t{y} * component.v / v_max_)];
        if (component.h == h_max_ && component.v == v_max_)
            return {near, near + picture_.width};

        std::vector<std::uint8_t> row(picture_.width);
        const bool half_width = 2 * component.h == h_max_;
        const bool half_height = 2 * component.v == v_max_;
        const bool interpolated = component.h == h_max_
                                      ? half_height
                                      : half_width && component.width > 2 && (half_height || component.v == v_max_);
        if (!interpolated) {
            for (std::size_t x = 0; x < row.size(); ++x)
                row[x] = near[x * component.h / h_max_];
            return row;
        }

        std::vector<int> sums(near, near + component.width);
        if (half_height) {
            const std::uint32_t neighbour = y % 2 == 1 ? std::min(y / 2 + 1, component.height - 1) : y / 2 - (y > 0);
            const std::uint8_t* far = &component.samples[stride * neighbour];
            for (std::size_t x = 0; x < sums.size(); ++x)
                sums[x] = 3 * near[x] + far[x];
        }
        const bool in_both = half_width && half_height;
        for (std::size_t x = 0; x < row.size(); ++x) {
            const std::size_t i = half_width ? x / 2 : x;
            const bool is_odd = (half_width ? x : y) % 2 == 1;
            const std::size_t beside = is_odd ? std::min(i + 1, sums.size() - 1) : i - (i > 0);
            const int sum = half_width ? 3 * sums[i] + sums[beside] : sums[i];
            const int rounding = in_both ? 8 - is_odd : 1 + is_odd;
            row[x] = static_cast<std::uint8_t>((sum + rounding) >> (in_both ? 4 : 2));
        }
        return row;
    }

    /// True if the first three components are YCbCr. A JFIF segment takes precedence over an Adobe segment, and that
    /// over the ids of the components.
    bool has_luma() const
    {
        if (components_.size() == 4)
            return adobe_transform_ && *adobe_transform_ != 0;
        if (is_jfif_)
            return true;
        if (adobe_transform_)
            return *adobe_transform_ != 0;
        return !(components_[0].id == 'R' && components_[1].id == 'G' && components_[2].id == 'B');
    }

    Bitmap convert()
    {
        for (JpegComponent& component : components_) {
            for (std::size_t i = 0; i < component.coefficients.size(); ++i)
                transform_jpeg_block(component.coefficients[i], component, i % component.blocks_x,
                                     i / component.blocks_x);
            component.coefficients = {};
        }
        std::array<std::vector<std::uint8_t>, 4> rows;
        for (std::uint32_t y = 0; y < picture_.height; ++y) {
            for (std::size_t i = 0; i < components_.size(); ++i)
                rows[i] = full_row(components_[i], y);
            convert_row(rows, picture_.row(y));
        }
        return std::move(picture_);
    }

    void convert_row(const std::array<std::vector<std::uint8_t>, 4>& rows, std::uint8_t* rgb) const
    {
        const bool is_grey = components_.size() == 1;
        const bool is_cmyk = components_.size() == 4;
        const bool is_ycc = !is_grey && has_luma();
        for (std::size_t x = 0; x < picture_.width; ++x, rgb += 3) {
            std::array<std::uint8_t, 3> colour = {rows[0][x], rows[0][x], rows[0][x]};
            if (is_ycc)
                colour = jpeg_ycc_to_rgb(rows[0][x], rows[1][x], rows[2][x]);
            else if (!is_grey)
                colour = {rows[0][x], rows[1][x], rows[2][x]};
            for (std::size_t i = 0; i < 3; ++i) {
                // As Adobe's programs write it, CMYK holds the share of light that each ink transmits, and YCCK its
                // complement.
                const int transmitted = is_ycc ? 255 - colour[i] : colour[i];
                rgb[i] = is_cmyk ? static_cast<std::uint8_t>((transmitted * rows[3][x] + 127) / 255) : colour[i];
            }
        }
    }

    std::string_view bytes_;
    Bitmap picture_;
    std::vector<JpegComponent> components_;
    std::uint32_t h_max_ = 1;
    std::uint32_t v_max_ = 1;
    bool progressive_ = false;
    bool is_jfif_ = false;
    std::optional<std::uint8_t> adobe_transform_;
    std::array<std::optional<std::array<std::uint16_t, 64>>, 4> quantization_tables_;
    std::array<PrefixCode, 4> dc_tables_;
    std::array<PrefixCode, 4> ac_tables_;
    std::size_t restart_interval_ = 0;

    BitReader bits_{{}}; ///< state of the current scan
    JpegScan scan_;
    unsigned end_of_band_run_ = 0;
    std::size_t block_visits_ = 0;
};

} // namespace

Bitmap read_jpeg(std::string_view bytes)
{
    return JpegDecoder(bytes).decode();
}

} // namespace multipath
