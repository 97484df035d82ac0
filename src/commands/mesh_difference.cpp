#include "commands/result_difference.h"
#include "scene/text_format.h"

#include <algorithm>

namespace multipath {

namespace {

/// What of a binary mesh has to be the same; `text` is the part that describes the numbers.
struct BinaryMesh
{
    std::string text;
    std::string numbers;
};

/// Without comments.
BinaryMesh parts_of_ply(const std::string& bytes)
{
    const std::string last = "end_header\n";
    const std::size_t end = std::min(bytes.find(last), bytes.size());
    BinaryMesh mesh{"", bytes.substr(end)};
    for (std::size_t at = 0; at < end;) {
        const std::size_t next = std::min(bytes.find('\n', at), end - 1) + 1;
        if (bytes.compare(at, 8, "comment ") != 0)
            mesh.text += bytes.substr(at, next - at);
        at = next;
    }
    return mesh;
}

/// Without the record, nor the lengths and the filling that depend on it.
BinaryMesh parts_of_glb(const std::string& bytes)
{
    const std::string start_of_numbers("BIN\0", 4);
    const std::size_t end = std::min(bytes.find(start_of_numbers), bytes.size());
    const std::string_view record = glb_record(bytes);
    const std::size_t first = std::min<std::size_t>(20, end);
    const auto begin = record.empty() ? first : static_cast<std::size_t>(record.data() - bytes.data());
    const std::size_t after = begin + record.size();
    const std::size_t brace = bytes.rfind('}', end);
    if (brace == std::string::npos || begin > after || after > brace)
        return {bytes.substr(0, end), bytes.substr(end)};
    return {bytes.substr(first, begin - first) + bytes.substr(after, brace - after), bytes.substr(end)};
}

ResultDifference difference(const BinaryMesh& then, const BinaryMesh& now)
{
    if (then.text != now.text)
        return {"the descriptions of the meshes differ: other numbers of vertices or faces, or other materials"};
    if (then.numbers == now.numbers)
        return {};
    const auto place = std::mismatch(then.numbers.begin(), then.numbers.end(), now.numbers.begin(), now.numbers.end());
    const auto at = static_cast<std::uint64_t>(place.first - then.numbers.begin());
    return {"the vertices or faces differ, from byte " + grouped(at + 1) + " of " + grouped(then.numbers.size()) +
            " on"};
}

} // namespace

ResultDifference ply_difference(const std::string& then, const std::string& now)
{
    return difference(parts_of_ply(then), parts_of_ply(now));
}

ResultDifference glb_difference(const std::string& then, const std::string& now)
{
    return difference(parts_of_glb(then), parts_of_glb(now));
}

} // namespace multipath
