#include "study/study_table.h"

#include "export/csv_text.h"
#include "scene/text/text_format.h"

#include <algorithm>
#include <cinttypes>
#include <cstdlib>

namespace multipath {

namespace {

using KindPart = std::string CurveKind::*;

/// True if another curve of the same method differs in this part.
bool differs(const Study& study, const Curve& curve, KindPart part)
{
    return std::any_of(study.curves.begin(), study.curves.end(), [&](const Curve& other) {
        return other.kind.method == curve.kind.method && other.kind.*part != curve.kind.*part;
    });
}

std::string reference_text(const Study& study)
{
    if (!study.reference_relative_square)
        return "reference: of unknown error; no point is left out of the fits\n";
    return format("reference: relative MSE %.2g by its own estimate; points less than ten times above it are marked * "
                  "and left out of the fits\n",
                  *study.reference_relative_square);
}

std::string point_text(const Study& study, const CurvePoint& point)
{
    const std::string spread =
        study.executions > 1 ? format(" +- %3.0f %%", 100.0 * point.relative_error / point.relative) : "";
    return format("  %12" PRIu64 "  %12.0f  %12.0f  %11.4e%s%s  %10.3g\n", point.lines, point.local_lines,
                  point.global_lines, point.relative, spread.c_str(), point.above_reference ? " " : "*", point.seconds);
}

std::string law_text(const Curve& curve)
{
    if (!curve.law)
        return "slope: too few points\n";
    return format("slope %.3f +- %.3f (95 %%: %.3f to %.3f)\n", curve.law->exponent, curve.law->exponent_error,
                  curve.law->exponent - exponent_interval(*curve.law),
                  curve.law->exponent + exponent_interval(*curve.law));
}

/// The table of a study as study_csv() writes it.
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

std::string curve_label(const Study& study, const Curve& curve)
{
    std::string label = curve.kind.method + ", " + curve.kind.sequence;
    if (differs(study, curve, &CurveKind::pairing) || curve.kind.pairing != "4d")
        label += ", " + curve.kind.pairing;
    if (differs(study, curve, &CurveKind::chords))
        label += ", " + curve.kind.chords;
    if (differs(study, curve, &CurveKind::line_order))
        label += curve.kind.line_order == "shuffled" ? ", shuffled" : ", in order";
    return label;
}

std::string study_text(const Study& study)
{
    std::string text = reference_text(study);
    if (study.executions > 1)
        text += format("every point is the mean of %d executions\n", study.executions);
    for (const Curve& curve : study.curves) {
        text += "\n" + curve_label(study, curve) + "\n";
        text += format("  %12s  %12s  %12s  %s%s  %10s\n", "lines", "local", "global", "relative MSE",
                       study.executions > 1 ? "        " : "", "seconds");
        for (const CurvePoint& point : curve.points)
            text += point_text(study, point);
        text += "  " + law_text(curve);
    }
    return text;
}

std::string study_csv(const Study& study, const std::vector<std::string>& comments)
{
    std::string csv = comment_lines(comments);
    if (study.reference_relative_square)
        csv += format("# reference_relative_mse: %.17g\n", *study.reference_relative_square);
    csv += "method,sequence,lines,local_lines,global_lines,mse,relative_mse,standard_error,seconds,slope,slope_error,"
           "in_fit,replicates,pairing,chords,line_order\n";
    for (const Curve& curve : study.curves)
        for (const CurvePoint& p : curve.points) {
            const std::string slope =
                curve.law ? format("%.17g,%.17g", curve.law->exponent, curve.law->exponent_error) : ",";
            csv += curve.kind.method + "," + csv_field(curve.kind.sequence) +
                   format(",%" PRIu64 ",%.0f,%.0f,%.17g,%.17g,", p.lines, p.local_lines, p.global_lines, p.mean_square,
                          p.relative) +
                   (study.executions > 1 ? format("%.17g", p.relative_error) : "") + format(",%.4g,", p.seconds) +
                   slope + format(",%d,%d,", p.above_reference ? 1 : 0, study.executions) + curve.kind.pairing + "," +
                   curve.kind.chords + "," + curve.kind.line_order + "\n";
        }
    return csv;
}

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
