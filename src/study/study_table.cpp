#include "study/study_table.h"

#include "base/text_format.h"
#include "export/csv_text.h"

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdlib>

namespace multipath {

namespace {

std::string reference_text(const Study& study)
{
    if (!study.reference_relative_square)
        return "reference: of unknown error; no point is left out of the fits\n";
    return format("reference: relative MSE %.2g by its own estimate; points less than ten times above it are marked * "
                  "and left out of the fits\n",
                  *study.reference_relative_square);
}

const char* name_of(Abscissa varied)
{
    return varied == Abscissa::lines ? "lines" : varied == Abscissa::ratio ? "ratio" : "threshold";
}

/// CurvePoint::rule in words.
const char* rule_words(const std::string& rule)
{
    return rule == "auto" ? "(3)" : "pilot";
}

std::string point_text(const Study& study, const CurvePoint& point)
{
    const std::string spread =
        study.executions > 1 ? format(" +- %3.0f %%", 100.0 * point.relative_error / point.relative) : "";
    const std::string first =
        study.varied == Abscissa::lines ? std::to_string(point.lines) : format("%.4g", point.setting);
    return format("  %12s  %12.0f  %12.0f  %11.4e%s%s  %10.3g%s\n", first.c_str(), point.local_lines,
                  point.global_lines, point.relative, spread.c_str(), point.above_reference ? " " : "*", point.seconds,
                  point.rule.empty() ? "" : format("  by %s", rule_words(point.rule)).c_str());
}

/// The least error, and the error of each rule as a multiple of it.
std::string ratios_text(const Curve& curve)
{
    if (!curve.ratios)
        return "  least error: too few points\n";
    const RatioFindings& found = *curve.ratios;
    std::string text =
        format("  least error %.4e at ratio %s %s%s\n", found.least, interval_words(found.best).c_str(),
               found.law ? "by a fitted curve, with the 95 % interval" : "as measured", fit_words(found).c_str());
    for (const CurvePoint& point : curve.points)
        if (const auto loss = found.loss.find(point.rule); loss != found.loss.end())
            text += format("  at the ratio %.3g of %s: %s times the least\n", point.setting, rule_words(point.rule),
                           interval_words(loss->second).c_str());
    if (found.formula_over_pilot)
        text += format("  (3) over pilot: %s times its error\n", interval_words(*found.formula_over_pilot).c_str());
    return text;
}

std::string law_text(const Curve& curve)
{
    if (!curve.law)
        return "slope: too few points\n";
    return format("slope %.3f +- %.3f (95 %%: %.3f to %.3f)\n", curve.law->exponent, curve.law->exponent_error,
                  curve.law->exponent - exponent_interval(*curve.law),
                  curve.law->exponent + exponent_interval(*curve.law));
}

} // namespace

std::string fixed(double value, int decimals)
{
    const std::string digits = format("%.*f", decimals, std::abs(value));
    const bool zero = digits.find_first_not_of("0.") == std::string::npos;
    return (value < 0.0 && !zero ? "−" : "") + digits;
}

std::string slope_words(const std::optional<PowerLaw>& law)
{
    return law ? fixed(law->exponent, 3) + " ± " + fixed(exponent_interval(*law), 3) : "none";
}

std::string interval_words(const Estimate& estimate)
{
    if (estimate.low == 0.0 && std::isinf(estimate.high))
        return format("%.2f", estimate.value);
    return format("%.2f (%.2f to %.2f)", estimate.value, estimate.low, estimate.high);
}

std::string fit_words(const RatioFindings& found)
{
    return found.probability ? format("; p = %.2f", *found.probability) : "";
}

std::string curve_label(const Study& study, const Curve& curve)
{
    std::string label = curve.kind.method;
    if (curve.kind.sequence.empty())
        return label;
    label += ", " + curve.kind.sequence;
    for (std::string CurveKind::*const part : {&CurveKind::pairing, &CurveKind::chords, &CurveKind::line_order})
        if (std::any_of(study.curves.begin(), study.curves.end(), [&](const Curve& other) {
                return other.kind.method == curve.kind.method && other.kind.*part != curve.kind.*part;
            }))
            label += ", " + curve.kind.*part;
    return label;
}

std::string study_text(const Study& study)
{
    std::string text = reference_text(study);
    if (study.executions > 1)
        text += format("every point is the mean of %d executions\n", study.executions);
    for (const Curve& curve : study.curves) {
        text += "\n" + curve_label(study, curve) + "\n";
        text += format("  %12s  %12s  %12s  %s%s  %10s\n", name_of(study.varied), "local", "global", "relative MSE",
                       study.executions > 1 ? "        " : "", "seconds");
        for (const CurvePoint& point : curve.points)
            text += point_text(study, point);
        if (study.varied == Abscissa::lines)
            text += "  " + law_text(curve);
        if (study.varied == Abscissa::ratio)
            text += ratios_text(curve);
    }
    return text;
}

std::string study_csv(const Study& study, const std::vector<std::string>& comments)
{
    std::string csv = comment_lines(comments);
    if (study.reference_relative_square)
        csv += format("# reference_relative_mse: %.17g\n", *study.reference_relative_square);
    csv += "method,sequence,lines,local_lines,global_lines,mse,relative_mse,standard_error,seconds,slope,slope_error,"
           "in_fit,replicates,pairing,chords,line_order";
    const bool varied = study.varied != Abscissa::lines;
    csv += (varied ? "," + std::string(name_of(study.varied)) + ",rule" : "") + "\n";
    for (const Curve& curve : study.curves)
        for (const CurvePoint& p : curve.points) {
            const std::string slope =
                curve.law ? format("%.17g,%.17g", curve.law->exponent, curve.law->exponent_error) : ",";
            csv += csv_field(curve.kind.method) + "," + csv_field(curve.kind.sequence) +
                   format(",%" PRIu64 ",%.0f,%.0f,%.17g,%.17g,", p.lines, p.local_lines, p.global_lines, p.mean_square,
                          p.relative) +
                   (study.executions > 1 ? format("%.17g", p.relative_error) : "") + format(",%.4g,", p.seconds) +
                   slope + format(",%d,%d,", p.above_reference ? 1 : 0, study.executions) + curve.kind.pairing + "," +
                   curve.kind.chords + "," + curve.kind.line_order +
                   (varied ? format(",%.6g,", p.setting) + p.rule : "") + "\n";
        }
    return csv;
}

Curve read_curve(const std::string& path, const std::string& name)
{
    const CsvTable table = read_csv(path);
    const std::size_t lines = table.column("lines");
    const std::size_t relative = table.column("relative_mse");
    const std::optional<std::size_t> error = table.find_column("standard_error");
    const std::optional<std::size_t> seconds = table.find_column("seconds");
    const auto positive = [&](const CsvRow& row, std::size_t column) {
        const double value = table.number(row, column);
        if (!(value > 0.0))
            table.refuse_field(row, column, "a number above 0");
        return value;
    };
    Curve curve{{name, "", "", "", ""}, {}, {}};
    for (const CsvRow& row : table.rows) {
        CurvePoint point;
        const double count = positive(row, lines);
        if (!(count < 0x1p63) || count != std::floor(count))
            table.refuse_field(row, lines, "a whole number");
        point.lines = static_cast<std::uint64_t>(count);
        if (!curve.points.empty() && point.lines <= curve.points.back().lines)
            table.refuse_field(row, lines, "more than in the row before");
        point.relative = positive(row, relative);
        point.relative_error = error && !row.fields[*error].empty() ? table.number(row, *error) : 0.0;
        point.seconds = seconds ? positive(row, *seconds) : 0.0;
        curve.points.push_back(point);
    }
    if (curve.points.empty())
        refuse(table.place(table.header), "no row after the header, expected one per point");
    curve.law = fit(curve.points); // (2)
    return curve;
}

} // namespace multipath
