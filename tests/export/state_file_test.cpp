#include "base/errors.h"
#include "doctest/doctest.h"
#include "export/state_file.h"
#include "scene/scene_builder.h"
#include "test_scenes.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace state_file_test {

using namespace multipath;

namespace {

struct Values
{
    std::uint64_t whole = 0;
    double real = 0.0;
    std::vector<float> floats;
    std::vector<Rgb> colours;
    std::vector<std::uint32_t> counts = std::vector<std::uint32_t>(3);
    std::vector<std::string> texts;

    void visit(Archive& archive)
    {
        archive.value<std::uint64_t>("whole", whole);
        {
            const Archive::Inner inner(archive, "inner");
            archive.value<double>("whole", real);
            archive.growing_list<float>("floats", floats);
        }
        archive.growing_list<double>("colours", colours);
        archive.list<std::uint32_t>("counts", counts);
        archive.texts("texts", texts);
    }
};

template <class Visited>
std::string written(Visited& visited)
{
    std::string bytes;
    StateWriter writer([&](std::string_view more) { bytes += more; });
    visited.visit(writer);
    writer.finish();
    return bytes;
}

StateReader reader(const std::string& bytes)
{
    return {"test.state", bytes};
}

Values some_values()
{
    return {~std::uint64_t{0},          -0.1,      {1.5f, -2.0f, 3.0f},
            {{1, 2, 3}, {4, 5, 1e300}}, {7, 8, 9}, {"", "two words", "\n"}};
}

/// The message of the refusal, or "".
std::string refusal(const std::string& bytes)
{
    try {
        StateReader state = reader(bytes);
        Values values;
        values.visit(state);
    } catch (const ArchiveError& error) {
        return error.what();
    }
    return "";
}

bool says(const std::string& text, const char* part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("a state with a number that is not finite is refused, whatever its checksum")
{
    for (const double number : {std::nan(""), HUGE_VAL}) {
        Values values = some_values();
        values.real = number;
        CHECK(says(refusal(written(values)), "not finite"));
    }
    Values values = some_values();
    values.floats[1] = std::nanf("");
    CHECK(says(refusal(written(values)), "not finite"));
}

TEST_CASE("a state gives back the bits that were put into it")
{
    Values before = some_values();
    const std::string bytes = written(before);
    CHECK(bytes.size() % 8 == 0);
    StateReader state = reader(bytes);
    Values after;
    after.visit(state);
    CHECK(after.whole == before.whole);
    CHECK(after.real == before.real);
    CHECK(after.floats == before.floats);
    CHECK(after.colours == before.colours);
    CHECK(after.counts == before.counts);
    CHECK(after.texts == before.texts);
}

TEST_CASE("the bytes of a state are those of its document")
{
    struct One
    {
        std::uint32_t number = 0x01020304;
        void visit(Archive& archive) { archive.value<std::uint32_t>("ab", number); }
    } one;
    const std::string bytes = written(one);
    const char expected[] = "multipath state 1      \n"
                            "\x02\0\0\0\x04\0\0\0\x01\0\0\0\0\0\0\0"
                            "ab\0\0\0\0\0\0\x04\x03\x02\x01\0\0\0\0"
                            "\0\0\0\0\0\0\0\0";
    CHECK(bytes.substr(0, bytes.size() - 8) == std::string(expected, sizeof expected - 1));
}

TEST_CASE("every byte that changes is noticed, words that are exchanged, and every end that is missing")
{
    Values values = some_values();
    const std::string bytes = written(values);
    REQUIRE(refusal(bytes).empty());
    for (std::size_t k = 0; k < bytes.size(); ++k) {
        CAPTURE(k);
        std::string bent = bytes;
        bent[k] = static_cast<char>(bent[k] ^ 4);
        CHECK(!refusal(bent).empty());
        CHECK(!refusal(bytes.substr(0, k)).empty());
    }
    for (std::size_t k = 24; k + 16 < bytes.size(); k += 8) { // words after the header
        CAPTURE(k);
        const std::string exchanged =
            bytes.substr(0, k) + bytes.substr(k + 8, 8) + bytes.substr(k, 8) + bytes.substr(k + 16);
        CHECK((exchanged == bytes || says(refusal(exchanged), "checksum")));
    }
    CHECK(says(refusal(bytes.substr(0, bytes.size() - 8)), "damaged"));
    CHECK(says(refusal(""), "not a state"));
    CHECK(says(refusal("multipath state 12     \n"), "newer version of multipath (format 12)"));
}

TEST_CASE("arrays of another length or kind are refused, and those that are not there")
{
    Values values = some_values();
    values.counts = {1, 2};
    CHECK(says(refusal(written(values)), "'counts' has 2 numbers, expected 3"));
    struct Other
    {
        double whole = 1.0;
        void visit(Archive& archive) { archive.value<double>("whole", whole); }
    } other;
    CHECK(says(refusal(written(other)), "no 'whole'"));
}

TEST_CASE("an array that is there twice is refused")
{
    struct Twice
    {
        Values values = some_values();
        void visit(Archive& archive)
        {
            values.visit(archive);
            archive.value<std::uint64_t>("whole", values.whole);
        }
    } twice;
    CHECK(says(refusal(written(twice)), "holds 'whole' twice"));
}

TEST_CASE("arrays are copied to another state, and told apart")
{
    Values values = some_values();
    const StateReader state = reader(written(values));
    std::string bytes;
    StateWriter copy([&](std::string_view more) { bytes += more; });
    std::uint64_t whole = 5;
    copy.value<std::uint64_t>("whole", whole);
    state.copy_rest(copy);
    copy.finish();
    StateReader copied = reader(bytes);
    Values after;
    after.visit(copied);
    CHECK(after.whole == 5);
    CHECK(after.colours == values.colours);
    CHECK(copied.has_same(state, "inner/floats"));
    CHECK(!copied.has_same(state, "whole"));
}

TEST_CASE("a scene comes back from a state as it was")
{
    SceneBuilder builder;
    const std::uint32_t lamp = builder.material({0.1, 0.2, 0.3}, {4, 5, 6});
    builder.room({0, 0, 0}, {2, 3, 4}, builder.grey(0.5, 0.0)).triangle({1, 1, 1}, {1, 1, 2}, {2, 1, 1}, lamp);
    const Scene scene = builder.scene(0.3);
    ArchivedScene kept = archived(scene);
    const std::string bytes = written(kept);
    StateReader state = reader(bytes);
    ArchivedScene read;
    read.visit(state);
    const Scene again = restored(read);
    CHECK(again.hash() == scene.hash());
    CHECK(again.patch_count() == scene.patch_count());
    CHECK(again.materials()[1].name == scene.materials()[1].name);
    CHECK(again.material_of(0).reflectance == scene.material_of(0).reflectance);

    const Scene refined = unevenly_refined(scene);
    const ArchivedScene kept_refined = archived(refined);
    ArchivedScene copy = kept_refined;
    const std::string more_bytes = written(copy);
    StateReader refined_state = reader(more_bytes);
    ArchivedScene read_refined;
    read_refined.visit(refined_state);
    CHECK(restored(read_refined).hash() == refined.hash());
    CHECK(restored(read_refined).levels() == refined.levels());
    for (const std::size_t changed : {std::size_t{0}, refined.levels().size() - 1}) {
        ArchivedScene damaged = kept_refined;
        damaged.levels[changed] = static_cast<std::uint8_t>(damaged.levels[changed] + 1);
        CHECK_THROWS_AS(restored(damaged), ArchiveError);
        damaged.levels.pop_back();
        CHECK_THROWS_AS(restored(damaged), ArchiveError);
    }

    ArchivedScene finer = kept;
    finer.patch_size = 1e-6;
    CHECK_THROWS_AS(restored(finer), ArchiveError);
    ArchivedScene other = kept;
    SceneFile changed = *kept.file;
    changed.materials[1].emittance.r += 1.0;
    other.file = std::make_shared<const SceneFile>(changed);
    CHECK_THROWS_AS(restored(other), ArchiveError);
    changed.material[0] = 2;
    other.file = std::make_shared<const SceneFile>(changed);
    CHECK_THROWS_AS(written(other), ArchiveError);
}

} // namespace state_file_test
