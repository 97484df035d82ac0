#pragma once

#include "base/archive.h"
#include "scene/scene.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// Writes a state file: a checksummed container of named arrays (docs/builders/state_format.md). The same content gives
/// the same bytes on every machine. An archive that only writes.
class StateWriter : public Archive
{
public:
    friend class StateReader;

    /// Receives the bytes of the file in order, in pieces.
    using Sink = std::function<void(std::string_view bytes)>;

    explicit StateWriter(Sink sink);
    bool has(const std::string& name) const { return names_.count(name) > 0; } ///< true if it has been written
    void finish();                                                             ///< writes the end mark and checksum

protected:
    void write(const std::string& name, Scalar scalar, const void* data, std::size_t length) override;
    void put(std::string_view bytes); ///< padded with zeros to a multiple of eight bytes

private:
    /// `bytes`: in little-endian order.
    void put_array(const std::string& name, Scalar scalar, std::size_t length, std::string_view bytes);

    Sink sink_;
    std::set<std::string> names_;
    std::uint64_t checksum_ = 0;
};

/// True if the file can be read and begins like a state file.
bool is_state_file(const std::string& path);

/// Reads the arrays of a state file. An archive that only reads.
class StateReader : public Archive
{
public:
    /// Throws ArchiveError for a file that is no state file, was written by a newer version, or is damaged. Throws
    /// InputError if it cannot be read.
    explicit StateReader(const std::string& path);
    /// Reads from the bytes of a file; `name` is for messages. Throws ArchiveError likewise.
    StateReader(std::string name, std::string bytes);

    const std::string& name() const { return name_; }

    const std::string& bytes() const { return bytes_; }

    /// Copies all arrays that `other` does not have yet.
    void copy_rest(StateWriter& other) const;
    /// True if both files have this array with the same type and bytes.
    bool has_same(const StateReader& other, const std::string& name) const;

protected:
    void read(const std::string& name, Scalar scalar, void* data, std::size_t length) override;
    bool holds(const std::string& name) const override;
    std::size_t length(const std::string& name, Scalar scalar) override;

private:
    struct Array
    {
        Scalar scalar;
        std::size_t length; ///< number of scalars
        std::size_t offset; ///< [byte] in bytes_
    };

    [[noreturn]] void refuse(const std::string& problem) const;
    std::uint64_t word(std::size_t offset) const;
    void require_whole() const;
    void find_arrays();
    const Array& array(const std::string& name, Scalar scalar) const;
    std::string_view bytes_of(const Array& array) const
    {
        return {bytes_.data() + array.offset, array.length * size_of(array.scalar)};
    }

    std::string name_;
    std::string bytes_;
    std::map<std::string, Array> arrays_;
};

/// A scene as stored in a state file: complete, so that neither resuming a run nor rendering needs the scene's own
/// files.
struct ArchivedScene
{
    std::shared_ptr<const SceneFile> file; ///< data of the scene, shared with it; null until visit() reads them
    double patch_size = 0.0;               ///< [scene units]
    std::uint64_t two_sided = 0;           ///< 0 or 1
    std::uint64_t patches = 0;             ///< number of patches
    std::uint64_t hash = 0;                ///< Scene::hash()
    std::vector<std::uint8_t> levels{};    ///< Scene::levels()

    /// Writes or reads all members. Throws ArchiveError for values that no scene can have (a damaged file).
    void visit(Archive& archive);
};

ArchivedScene archived(const Scene& scene);

/// Rebuilds the scene. Throws ArchiveError if the stored number of patches, levels or hash do not fit the stored scene.
Scene restored(const ArchivedScene& archived);

} // namespace multipath
