// A state file consists of a header with the version of the format, arrays, an end mark and a checksum. An array is
// stored as its scalar type and name length, its length, its name and its scalars in little-endian order. Everything is
// padded to words of eight bytes (docs/builders/state_format.md). After reading, all values are checked that the
// program relies on, since a damaged or forged file may have a valid checksum.

#include "export/state_file.h"

#include "base/errors.h"
#include "base/file_bytes.h"
#include "base/mix_bits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <stdexcept>
#include <utility>

namespace multipath {

namespace {

constexpr std::string_view state_kind = "multipath state ";
constexpr std::string_view state_header = "multipath state 1      \n"; // three words; 1 is the version of the format
constexpr std::size_t word_size = 8;

std::uint64_t word_at(const char* bytes)
{
    std::uint64_t word = 0;
    for (std::size_t k = word_size; k-- > 0;)
        word = word << 8 | static_cast<unsigned char>(bytes[k]);
    return word;
}

std::string word_bytes(std::uint64_t word)
{
    std::string bytes(word_size, '\0');
    for (std::size_t k = 0; k < word_size; ++k)
        bytes[k] = static_cast<char>(word >> (8 * k) & 0xffu);
    return bytes;
}

/// Continues the checksum `before` over a whole number of words. A change of any single word changes the result.
std::uint64_t checksum(std::uint64_t before, std::string_view bytes)
{
    for (std::size_t k = 0; k < bytes.size(); k += word_size)
        before = mix_bits(before ^ word_at(bytes.data() + k));
    return before;
}

std::size_t padded(std::size_t bytes)
{
    return (bytes + word_size - 1) / word_size * word_size;
}

constexpr bool little_endian = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__;

/// Converts `length` scalars between the byte order of this machine and the little-endian order of files.
void swap_on_big_endian(Scalar scalar, char* data, std::size_t length)
{
    const std::size_t size = size_of(scalar);
    if (!little_endian)
        for (std::size_t k = 0; k < length; ++k)
            std::reverse(data + k * size, data + (k + 1) * size);
}

/// True if all numbers are finite, as those of every run are.
template <class Number>
bool all_finite(const void* data, std::size_t length)
{
    const auto* const numbers = static_cast<const Number*>(data);
    return std::all_of(numbers, numbers + length, [](Number x) { return std::isfinite(x); });
}

} // namespace

StateWriter::StateWriter(Sink sink) : Archive(false), sink_(std::move(sink))
{
    put(state_header);
}

void StateWriter::put(std::string_view bytes)
{
    const std::size_t whole = bytes.size() / word_size * word_size;
    std::string rest(bytes.substr(whole));
    rest.resize(padded(rest.size()), '\0');
    checksum_ = checksum(checksum(checksum_, bytes.substr(0, whole)), rest);
    sink_(bytes.substr(0, whole));
    if (!rest.empty())
        sink_(rest);
}

void StateWriter::write(const std::string& name, Scalar scalar, const void* data, std::size_t length)
{
    const std::string_view bytes(static_cast<const char*>(data), length * size_of(scalar));
    if (little_endian) {
        put_array(name, scalar, length, bytes);
        return;
    }
    std::string swapped(bytes);
    swap_on_big_endian(scalar, swapped.data(), length);
    put_array(name, scalar, length, swapped);
}

void StateWriter::put_array(const std::string& name, Scalar scalar, std::size_t length, std::string_view bytes)
{
    names_.insert(name);
    put(word_bytes(static_cast<std::uint64_t>(scalar) << 32 | name.size()) + word_bytes(length));
    put(name);
    put(bytes);
}

void StateWriter::finish()
{
    put(word_bytes(0));
    sink_(word_bytes(checksum_));
}

bool is_state_file(const std::string& path)
{
    std::string start(state_kind.size(), '\0');
    std::ifstream(path, std::ios::binary).read(start.data(), static_cast<std::streamsize>(start.size()));
    return start == state_kind;
}

StateReader::StateReader(const std::string& path) : StateReader(path, bytes_of_file(path)) {}

StateReader::StateReader(std::string name, std::string bytes)
    : Archive(true), name_(std::move(name)), bytes_(std::move(bytes))
{
    require_whole();
    find_arrays();
}

void StateReader::refuse(const std::string& problem) const
{
    throw ArchiveError(name_ + ": " + problem);
}

std::uint64_t StateReader::word(std::size_t offset) const
{
    if (bytes_.size() < word_size || offset > bytes_.size() - word_size)
        refuse("damaged: the state ends too early; expected a whole copy");
    return word_at(bytes_.data() + offset);
}

void StateReader::require_whole() const
{
    const std::string_view start(bytes_.data(), std::min(bytes_.size(), state_header.size()));
    if (start.substr(0, state_kind.size()) != state_kind)
        refuse("not a state of multipath; expected a file such as room.state that 'multipath solve' wrote");
    if (start.size() == state_header.size() && start != state_header)
        refuse("written by a newer version of multipath (format " +
               std::string(
                   start.substr(state_kind.size(), start.find_first_of(" \n", state_kind.size()) - state_kind.size())) +
               "); expected format 1");
    const std::size_t end = bytes_.size() - std::min(bytes_.size(), word_size);
    if (end % word_size != 0 || end < state_header.size() ||
        checksum(0, std::string_view(bytes_.data(), end)) != word(end))
        refuse("damaged: the checksum is wrong; expected a whole copy");
}

void StateReader::find_arrays()
{
    std::size_t offset = state_header.size();
    while (const std::uint64_t head = word(offset)) {
        const auto scalar = static_cast<Scalar>(head >> 32);
        const auto name_size = static_cast<std::size_t>(head & 0xffffffffu);
        const std::uint64_t length = word(offset + word_size);
        offset += 2 * word_size;
        const std::size_t left = bytes_.size() - offset;
        const bool known = scalar == Scalar::bytes || scalar == Scalar::u32 || scalar == Scalar::u64 ||
                           scalar == Scalar::f32 || scalar == Scalar::f64;
        if (!known || name_size > left || length > left / size_of(scalar) ||
            padded(name_size) + padded(static_cast<std::size_t>(length) * size_of(scalar)) > left)
            refuse("damaged: it holds no whole array; expected a whole copy");
        const std::string name(bytes_.data() + offset, name_size);
        offset += padded(name_size);
        if (!arrays_.insert({name, {scalar, static_cast<std::size_t>(length), offset}}).second)
            refuse("damaged: it holds '" + name + "' twice; expected a whole copy");
        offset += padded(static_cast<std::size_t>(length) * size_of(scalar));
    }
}

const StateReader::Array& StateReader::array(const std::string& name, Scalar scalar) const
{
    const auto found = arrays_.find(name);
    if (found == arrays_.end() || found->second.scalar != scalar)
        refuse("damaged or of other work: it holds no '" + name + "'");
    return found->second;
}

bool StateReader::holds(const std::string& name) const
{
    return arrays_.count(name) > 0;
}

std::size_t StateReader::length(const std::string& name, Scalar scalar)
{
    return array(name, scalar).length;
}

void StateReader::read(const std::string& name, Scalar scalar, void* data, std::size_t length)
{
    const Array& found = array(name, scalar);
    if (found.length != length)
        refuse("damaged or of other work: '" + name + "' has " + std::to_string(found.length) + " numbers, expected " +
               std::to_string(length));
    if (length == 0)
        return;
    std::memcpy(data, bytes_.data() + found.offset, length * size_of(scalar));
    swap_on_big_endian(scalar, static_cast<char*>(data), length);
    if ((scalar == Scalar::f64 && !all_finite<double>(data, length)) ||
        (scalar == Scalar::f32 && !all_finite<float>(data, length)))
        refuse("damaged: '" + name + "' has a number that is not finite; expected a whole copy");
}

void StateReader::copy_rest(StateWriter& other) const
{
    for (const auto& [name, array] : arrays_)
        if (!other.has(name))
            other.put_array(name, array.scalar, array.length, bytes_of(array));
}

bool StateReader::has_same(const StateReader& other, const std::string& name) const
{
    const auto mine = arrays_.find(name);
    const auto others = other.arrays_.find(name);
    return mine != arrays_.end() && others != other.arrays_.end() && mine->second.scalar == others->second.scalar &&
           bytes_of(mine->second) == other.bytes_of(others->second);
}

namespace {

void visit_materials(Archive& archive, std::vector<Material>& materials)
{
    archive.records(
        materials, field<char>("material names", &Material::name), field<char>("material sources", &Material::source),
        field<double>("reflectances", &Material::reflectance), field<double>("emittances", &Material::emittance));
}

/// Shapes and vectors of the surfaces. Writing rebuilds the list from the same numbers.
void visit_surfaces(Archive& archive, SurfaceList& surfaces)
{
    std::vector<std::uint32_t> shapes;
    std::vector<Vec3> corners; // origin, edge_u and edge_v of each surface
    for (const Surface& surface : surfaces) {
        shapes.push_back(surface.shape == Shape::triangle ? 1 : 0);
        corners.insert(corners.end(), {surface.origin, surface.edge_u, surface.edge_v});
    }
    archive.growing_list<std::uint32_t>("triangles", shapes);
    corners.resize(3 * shapes.size());
    archive.list<double>("surfaces", corners);
    surfaces.clear();
    for (std::size_t s = 0; s < shapes.size(); ++s)
        surfaces.push_back({shapes[s] == 1 ? Shape::triangle : Shape::parallelogram, corners[3 * s], corners[3 * s + 1],
                            corners[3 * s + 2]});
}

// Checks of properties that scene readers guarantee and the program relies on.

void require(bool sound, const std::string& problem)
{
    if (!sound)
        throw ArchiveError("the state is damaged: " + problem);
}

bool all_within(std::initializer_list<double> values, double low, double high)
{
    return std::all_of(values.begin(), values.end(), [&](double x) { return low <= x && x <= high; });
}

bool is_within(Rgb colour, double high)
{
    return all_within({colour.r, colour.g, colour.b}, 0.0, high);
}

bool is_sound(const Surface& surface)
{
    constexpr double far = 1e30;
    const auto near = [&](Vec3 v) { return all_within({v.x, v.y, v.z}, -far, far); };
    const double area = surface.area();
    return near(surface.origin) && near(surface.edge_u) && near(surface.edge_v) && area > 0.0 && std::isfinite(area);
}

bool is_sound(const Material& material)
{
    return is_within(material.reflectance, 1.0) && is_within(material.emittance, 1e30);
}

bool is_sound(const Sun& sun)
{
    return all_within({length(sun.direction)}, 1.0 - 1e-9, 1.0 + 1e-9) && is_within(sun.irradiance, 1e30);
}

template <class List>
void require_sound(const List& list)
{
    for (const auto& element : list)
        require(is_sound(element), "no such surface or material");
}

void require_below(const std::vector<std::uint32_t>& numbers, std::size_t limit)
{
    for (const std::uint32_t number : numbers)
        require(number < limit, "no such material or group");
}

using TextureList = std::vector<std::shared_ptr<const Texture>>;

/// Makes textures of names that end with their lines, and of the bytes of their files one after the other.
TextureList textures_of(const std::string& names, const std::string& bytes, const std::vector<std::uint64_t>& lengths,
                        const std::vector<std::uint32_t>& repeats)
{
    TextureList textures;
    std::size_t begin = 0;
    std::size_t name_begin = 0;
    for (std::size_t k = 0; k < lengths.size(); ++k) {
        const std::size_t name_end = names.find('\n', name_begin);
        require(lengths[k] <= bytes.size() - begin && name_end != std::string::npos, "a texture is not whole");
        try {
            textures.push_back(std::make_shared<const Texture>(names.substr(name_begin, name_end - name_begin),
                                                               bytes.substr(begin, lengths[k]), repeats[k] != 0));
        } catch (const ImageError& error) {
            throw ArchiveError(std::string("the state is damaged: a texture ") + error.what());
        }
        begin += lengths[k];
        name_begin = name_end + 1;
    }
    return textures;
}

/// Textures as the bytes of their files. Writes nothing if there are none.
void visit_texture_files(Archive& archive, TextureList& textures)
{
    std::string names;
    std::string bytes;
    std::vector<std::uint64_t> lengths;
    std::vector<std::uint32_t> repeats;
    for (const std::shared_ptr<const Texture>& texture : textures) {
        names += texture->name() + '\n';
        bytes += texture->bytes();
        lengths.push_back(texture->bytes().size());
        repeats.push_back(texture->repeats() ? 1 : 0);
    }
    archive.optional_list<std::uint64_t>("texture lengths", lengths);
    if (lengths.empty())
        return;
    archive.growing_list<char>("texture names", names);
    archive.growing_list<char>("texture files", bytes);
    repeats.resize(lengths.size());
    archive.list<std::uint32_t>("texture repeats", repeats);
    if (archive.reads())
        textures = textures_of(names, bytes, lengths, repeats);
}

/// How the surfaces lie on textures. Writing rebuilds the list from the same numbers.
void visit_texture_frames(Archive& archive, std::vector<TextureFrame>& list)
{
    std::vector<std::array<double, 6>> frames; // origin, along_u and along_v of each surface
    std::vector<std::uint32_t> known;
    for (const TextureFrame& f : list) {
        frames.push_back({f.origin.s, f.origin.t, f.along_u.s, f.along_u.t, f.along_v.s, f.along_v.t});
        known.push_back(f.known ? 1 : 0);
    }
    archive.growing_list<std::uint32_t>("textured surfaces", known);
    frames.resize(known.size());
    archive.list<double>("texture frames", frames);
    list.clear();
    for (std::size_t s = 0; s < known.size(); ++s) {
        const std::array<double, 6>& f = frames[s];
        list.push_back({{f[0], f[1]}, {f[2], f[3]}, {f[4], f[5]}, known[s] != 0});
    }
}

void visit_textures(Archive& archive, SceneFile& scene)
{
    visit_texture_files(archive, scene.textures);
    if (scene.textures.empty())
        return;
    const std::size_t materials = scene.materials.size();
    archive.records(scene.materials, field<std::uint32_t>("material textures", &Material::texture),
                    field<double>("texture scales", &Material::texture_scale));
    visit_texture_frames(archive, scene.texture_frames);
    require(scene.materials.size() == materials && scene.texture_frames.size() == scene.own_surfaces(),
            "it has textures of other surfaces");
    for (const Material& material : scene.materials)
        require((material.texture == Material::no_texture || material.texture < scene.textures.size()) &&
                    is_within(material.texture_scale, 1.0),
                "no such texture");
}

} // namespace

void ArchivedScene::visit(Archive& archive)
{
    SceneFile kept = file ? *file : SceneFile{};
    std::vector<std::string> path = {kept.path};
    archive.texts("path", path);
    kept.path = path.empty() ? "" : path[0];
    archive.texts("groups", kept.groups);
    archive.texts("warnings", kept.warnings);
    visit_materials(archive, kept.materials);
    visit_surfaces(archive, kept.surfaces);
    for (std::vector<std::uint32_t>* numbers : {&kept.material, &kept.group, &kept.line})
        numbers->resize(kept.surfaces.size());
    archive.list<std::uint32_t>("material", kept.material);
    archive.list<std::uint32_t>("group", kept.group);
    archive.list<std::uint32_t>("line", kept.line);
    std::vector<std::uint32_t> sky(kept.sky_surfaces > 0 ? 1 : 0, kept.sky_surfaces);
    archive.optional_list<std::uint32_t>("sky surfaces", sky);
    require(sky.empty() || (sky.size() == 1 && sky[0] < kept.surfaces.size()), "no such sky");
    kept.sky_surfaces = sky.empty() ? 0 : sky[0];
    std::vector<Sun> sun(kept.sun ? 1 : 0, kept.sun.value_or(Sun{}));
    archive.optional_list<double>("sun", sun);
    require(sun.empty() || (sun.size() == 1 && is_sound(sun[0])), "no such sun");
    kept.sun = sun.empty() ? std::nullopt : std::optional(sun[0]);
    std::vector<std::uint32_t> photometric(kept.photometric ? 1 : 0, 1u);
    archive.optional_list<std::uint32_t>("photometric", photometric);
    kept.photometric = !photometric.empty();
    archive.texts("texture paths", kept.texture_files, true);
    visit_textures(archive, kept);
    archive.value<double>("patch size", patch_size);
    archive.value<std::uint64_t>("two-sided", two_sided);
    archive.value<std::uint64_t>("patches", patches);
    archive.value<std::uint64_t>("hash", hash);
    archive.optional_list<char>("levels", levels);
    require_sound(kept.surfaces);
    require_sound(kept.materials);
    require_below(kept.material, kept.materials.size());
    require_below(kept.group, kept.groups.size());
    if (archive.reads())
        file = std::make_shared<const SceneFile>(std::move(kept));
}

ArchivedScene archived(const Scene& scene)
{
    return {scene.shared_file(), scene.patch_size(), scene.two_sided() ? 1u : 0u,
            scene.patch_count(), scene.hash(),       scene.levels()};
}

Scene restored(const ArchivedScene& archived)
{
    const double sides = archived.two_sided != 0 ? 2.0 : 1.0;
    const double cells = archived.patch_size > 0.0 ? cell_count(*archived.file, archived.patch_size) : 0.0;
    const auto patches = static_cast<double>(archived.patches);
    const bool whole = archived.levels.empty();
    const bool fits = whole ? sides * cells == patches
                            : cells > 0.0 && sides * cells <= patches &&
                                  sides * static_cast<double>(archived.levels.size()) == patches;
    require(fits, "its scene has other patches"); // before memory is allocated for them
    Scene scene(archived.file, archived.patch_size, archived.two_sided != 0, 1);
    try {
        if (!whole)
            scene = scene.refined(archived.levels);
    } catch (const std::invalid_argument& error) {
        throw ArchiveError(std::string("the state is damaged: it has ") + error.what());
    }
    require(scene.hash() == archived.hash, "its scene is not the one that was solved");
    return scene;
}

} // namespace multipath
