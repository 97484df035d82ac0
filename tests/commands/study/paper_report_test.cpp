// What the report of the paper shows is what the commands before it have made, and its tables say what was found.

#include "study/report/paper_report.h"

#include "commands/study/paper_steps.h"
#include "study/report/agreeing_findings.h"

#include <algorithm>
#include <doctest/doctest.h>

namespace paper_report_test {

using namespace multipath;

namespace {

/// With the command of every file that the steps make.
PaperFindings findings_of_steps()
{
    PaperFindings findings = agreeing_findings();
    for (const PaperStep& step : paper_steps(true, "scenes", "paper"))
        for (const std::string& output : step.outputs)
            findings.commands[output] = typed(step);
    return findings;
}

template <class Block>
std::vector<Block> blocks(const Report& report)
{
    std::vector<Block> found;
    for (const ReportBlock& block : report)
        if (const Block* const one = std::get_if<Block>(&block))
            found.push_back(*one);
    return found;
}

/// The row of the table with this header that begins with this cell, without it.
std::vector<std::string> row(const Report& report, const std::string& first_header, const std::string& first_cell)
{
    for (const ReportTable& table : blocks<ReportTable>(report))
        for (const std::vector<std::string>& cells : table.rows)
            if (table.header[0] == first_header && cells[0] == first_cell)
                return {cells.begin() + 1, cells.end()};
    return {};
}

} // namespace

TEST_CASE("the report of the paper shows every figure that its commands draw once, beside the command")
{
    const PaperFindings findings = findings_of_steps();
    std::vector<std::string> drawn;
    for (const auto& [file, command] : findings.commands)
        if (file.substr(file.size() - 4) != ".csv")
            drawn.push_back(file);
    std::vector<std::string> shown;
    for (const ReportFigures& figures : blocks<ReportFigures>(paper_report(findings)))
        for (const ReportFigure& figure : figures.figures) {
            shown.push_back(figure.file);
            CHECK(figure.command == findings.commands.at(figure.file));
            CHECK(figure.command.find(" -o " + figure.file) != std::string::npos);
        }
    std::sort(shown.begin(), shown.end());
    CHECK(shown == drawn); // the map's order is that of the names
}

TEST_CASE("the report's first table has each statement with its verdict")
{
    PaperFindings findings = findings_of_steps();
    findings.four_chairs_up.report.ratio_first_shot = 0.43;         // the paper: 0.41
    findings.studies["figure9"] = shots_study(0.0495, 0.045, 0.05); // a ratio of 0.99 ± 0.014
    const std::vector<Claim> claims = paper_claims(findings);
    const Report report = paper_report(findings);
    int each[3] = {0, 0, 0};
    for (const Claim& claim : claims) {
        const std::vector<std::string> cells = row(report, "statement", claim.statement);
        REQUIRE(cells.size() == 3);
        CHECK(cells[0] == claim.expected);
        CHECK(cells[1].substr(0, claim.found.size()) == claim.found);
        CHECK(cells[2] == (claim.verdict == Verdict::holds       ? "holds"
                           : claim.verdict == Verdict::undecided ? "undecided"
                                                                 : "*differs*"));
        ++each[static_cast<int>(claim.verdict)];
    }
    CHECK(each[static_cast<int>(Verdict::undecided)] > 0);
    CHECK(each[static_cast<int>(Verdict::differs)] > 0);
}

TEST_CASE("the report's tables hold what was found, every row as many cells as its header")
{
    PaperFindings findings = findings_of_steps();
    findings.facts = {"program: multipath 1"};
    findings.five_cubes = {"5CUBES", 1234, {}};
    findings.five_cubes.report.figures = {2.1, 0.577, 0.65, 0.67};
    findings.five_cubes.report.ratio_first_shot = 0.85;
    findings.five_cubes.report.ratio_extended = 1.06;
    const Report report = paper_report(findings);
    for (const ReportTable& table : blocks<ReportTable>(report))
        for (const std::vector<std::string>& cells : table.rows)
            CHECK(cells.size() == table.header.size());
    using Cells = std::vector<std::string>;
    CHECK(row(report, "this run", "program") == Cells{"multipath 1"});
    CHECK(row(report, "", "5CUBES") == Cells{"1,234", "0.577", "2.10", "0.670", "0.650", "0.850", "1.060"});
    // With slopes of -1.5 and -1.1 the hundredfold of 2^15 lines has become a hundred times 2^(0.4 * 6).
    const Cells reuse = row(report, "at the most lines", "5CUBES, 2,097,152");
    REQUIRE(reuse.size() == 4);
    CHECK(reuse[2] == "528");
    CHECK(reuse[3].find("−1.500 ± ") == 0);
}

} // namespace paper_report_test
