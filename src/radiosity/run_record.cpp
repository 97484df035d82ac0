#include "radiosity/run_record.h"

#include <utility>

namespace multipath {

void RunRecord::finish_piece(Solution found)
{
    solution = std::move(found);
    lines = goal;
    goal = 0;
    ++pieces;
}

void RunRecord::visit(Archive& archive, std::uint32_t patches)
{
    archive.value<std::uint64_t>("pieces", pieces);
    archive.value<std::uint64_t>("lines", lines);
    archive.value<std::uint64_t>("goal", goal);
    if (pieces > 0)
        solution.visit(archive, patches);
}

} // namespace multipath
