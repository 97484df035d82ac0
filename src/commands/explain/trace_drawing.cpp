#include "commands/explain/trace_drawing.h"

namespace multipath {

std::vector<DrawnLine> drawn_lines(const StageTrace& trace)
{
    std::vector<DrawnLine> drawn;
    for (const TracedLine& line : trace.lines) {
        DrawnLine shape{trace.kind + " " + std::to_string(line.origin.number + 1), {}, {}};
        for (std::size_t k = 0; k < line.joins.size(); ++k)
            shape.segments.push_back({line.points[k], line.points[k + 1], line.joins[k]});
        for (const Crossing& crossing : line.crossings)
            shape.crossings.push_back(crossing.point);
        drawn.push_back(shape);
    }
    return drawn;
}

} // namespace multipath
