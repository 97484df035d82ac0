#include "study/study_reader.h"

#include "export/comments.h"
#include "export/csv_text.h"

#include <cstdlib>

namespace multipath {

namespace {

/// A table of one row per point with the columns that a study needs.
class StudyTable
{
public:
    explicit StudyTable(const std::string& path) : table_(read_csv(path)) {}

    const CsvTable& table() const { return table_; }
    const std::string& text(const CsvRow& row, const char* column) const { return row.fields[table_.column(column)]; }
    double number(const CsvRow& row, const char* column) const { return table_.number(row, table_.column(column)); }
    double number_or_zero(const CsvRow& row, const char* column) const
    {
        return text(row, column).empty() ? 0.0 : number(row, column);
    }
    CurveKind kind(const CsvRow& row) const
    {
        return {text(row, "method"), text(row, "sequence"), text(row, "pairing"), text(row, "chords"),
                text(row, "line_order")};
    }
    CurvePoint point(const CsvRow& row) const
    {
        CurvePoint point;
        point.lines = static_cast<std::uint64_t>(number(row, "lines"));
        point.local_lines = number(row, "local_lines");
        point.global_lines = number(row, "global_lines");
        point.mean_square = number(row, "mse");
        point.relative = number(row, "relative_mse");
        point.relative_error = number_or_zero(row, "standard_error");
        point.seconds = number(row, "seconds");
        point.above_reference = number(row, "in_fit") > 0.0;
        return point;
    }

private:
    CsvTable table_;
};

} // namespace

Study read_study(const std::string& path)
{
    const StudyTable rows(path);
    Study study;
    if (const auto square = comment_value(rows.table().comments, "reference_relative_mse"))
        study.reference_relative_square = std::strtod(square->c_str(), nullptr);
    for (const CsvRow& row : rows.table().rows) {
        const CurveKind kind = rows.kind(row);
        if (study.curves.empty() || !(study.curves.back().kind == kind))
            study.curves.push_back({kind, {}, {}});
        study.curves.back().points.push_back(rows.point(row));
        study.executions = static_cast<int>(rows.number(row, "replicates"));
    }
    for (Curve& curve : study.curves)
        curve.law = fit(curve.points);
    return study;
}

} // namespace multipath
