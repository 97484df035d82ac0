// The statements are judged from the numbers: findings that agree with the paper make all of them hold, and each is
// overturned by a finding against it.

#include "study/report/agreeing_findings.h"

#include <doctest/doctest.h>
#include <functional>
#include <stdexcept>

namespace paper_claims_test {

using namespace multipath;

namespace {

int claims_that_hold(const PaperFindings& findings)
{
    int count = 0;
    for (const Claim& claim : paper_claims(findings))
        count += claim.verdict == Verdict::holds ? 1 : 0;
    return count;
}

/// Of the statement with these words.
Verdict verdict_on(const PaperFindings& findings, const std::string& words)
{
    for (const Claim& claim : paper_claims(findings))
        if (claim.statement.find(words) != std::string::npos)
            return claim.verdict;
    throw std::out_of_range(words);
}

} // namespace

TEST_CASE("findings like the paper's make every statement hold, each finding against it overturns one")
{
    const PaperFindings findings = agreeing_findings();
    const int all = claims_that_hold(findings);
    CHECK(all == static_cast<int>(paper_claims(findings).size()));

    const std::vector<std::function<void(PaperFindings&)>> changes = {
        [](PaperFindings& f) { f.studies["figure4"].curves[0] = law_curve(kind("first-shot", "random"), 0.03, -1.08); },
        [](PaperFindings& f) { f.studies["order"].curves[1].law = f.studies["order"].curves[0].law; },
        [](PaperFindings& f) {
            f.studies["pairs"].curves[1] = law_curve(kind("first-shot", "sobol", "shuffled", "2d"), 0.1, -1.0);
        },
        [](PaperFindings& f) { f.four_chairs_up.report.ratio_first_shot = 0.43; },
        [](PaperFindings& f) { f.four_chairs.report.ratio_first_shot = 0.83; },
        [](PaperFindings& f) { f.four_chairs.report.ratio_extended = 1.08; },
        [](PaperFindings& f) { f.studies["figure7"] = shots_study(0.1, 0.06, 0.05); },
        [](PaperFindings& f) { f.studies["figure8"] = shots_study(0.5, 0.11, 0.05); },
        [](PaperFindings& f) { f.studies["figure9"] = shots_study(0.0535, 0.046, 0.05); },
        [](PaperFindings& f) { f.studies["figure9"] = shots_study(0.046, 0.03, 0.05); }};
    for (std::size_t k = 0; k < changes.size(); ++k) {
        CAPTURE(k);
        PaperFindings changed = findings;
        changes[k](changed);
        CHECK(claims_that_hold(changed) == all - 1);
    }
}

// Both errors are known to 1 % from 6 executions, so their ratio to 1.4 %, and t of 10 degrees of freedom is 2.23: 0.99
// is within the interval of 1, 0.95 is not. With 2 executions t is 4.30, which makes room for 0.95 too.
TEST_CASE("a ratio whose interval reaches over its limit decides nothing")
{
    PaperFindings findings = agreeing_findings();
    for (const auto& [first_shot, verdict] :
         {std::pair{0.0475, Verdict::holds}, {0.0495, Verdict::undecided}, {0.0530, Verdict::differs}}) {
        findings.studies["figure9"] = shots_study(first_shot, 0.045, 0.05);
        for (const Claim& claim : paper_claims(findings))
            if (claim.statement.find("beat local") != std::string::npos)
                CHECK(claim.verdict == verdict);
    }
    findings.studies["figure9"] = shots_study(0.0475, 0.045, 0.05);
    findings.studies["figure9"].executions = 2;
    CHECK(verdict_on(findings, "beat local") == Verdict::undecided);
}

// Slopes of three executions with few lines: what the quick set finds.
TEST_CASE("a slope differs only if its interval excludes what is expected")
{
    const auto with_sobol = [](double slope, double interval) {
        PaperFindings findings = agreeing_findings();
        for (const char* figure : {"figure3", "figure4"}) {
            PowerLaw& law = *findings.studies[figure].curves[3].law;
            law.exponent_error *= interval / exponent_interval(law);
            law.exponent = slope;
        }
        return findings;
    };
    CHECK(verdict_on(with_sobol(-1.11, 0.05), "do better") == Verdict::holds);
    CHECK(verdict_on(with_sobol(-0.991, 0.052), "do better") == Verdict::undecided);
    CHECK(verdict_on(with_sobol(-0.93, 0.052), "do better") == Verdict::differs);
    CHECK(verdict_on(with_sobol(-1.11, 0.05), "Table 1") == Verdict::holds);
    CHECK(verdict_on(with_sobol(-0.991, 0.052), "Table 1") == Verdict::undecided);
    CHECK(verdict_on(with_sobol(-0.93, 0.052), "Table 1") == Verdict::differs);
    CHECK(verdict_on(with_sobol(-1.11, 0.2), "Table 1") == Verdict::undecided); // agrees, but says little

    PaperFindings findings = agreeing_findings();
    PowerLaw& large_bases = *findings.studies["order"].curves[1].law;
    large_bases.exponent = -1.05; // -1.1 with smaller patches
    CHECK(verdict_on(findings, "Halton") == Verdict::holds);
    large_bases.exponent_error *= 0.08 / exponent_interval(large_bases);
    CHECK(verdict_on(findings, "Halton") == Verdict::undecided);
    large_bases.exponent = -1.3;
    CHECK(verdict_on(findings, "Halton") == Verdict::differs);
}

TEST_CASE("for a terminal every statement has its verdict, what was found and what the paper says")
{
    const std::vector<Claim> claims = {{"Lines cross", "often", "always", Verdict::undecided, "a remark"},
                                       {"Points fill", "evenly", "so", Verdict::holds, ""}};
    CHECK(claims_text(claims) == "undecided  Lines cross\n"
                                 "           always (paper: often)\n"
                                 "holds      Points fill\n"
                                 "           so (paper: evenly)\n");
}

TEST_CASE("Sobol's slopes are judged against -1 and against the printed ones")
{
    PaperFindings findings = agreeing_findings();
    const int all = claims_that_hold(findings);
    findings.studies["figure3"] = sequences_study(-1.21); // below -1, but 0.11 off
    CHECK(claims_that_hold(findings) == all - 1);
    findings.studies["figure3"] = sequences_study(-1.004); // neither below -1 nor within 0.1 for sure
    CHECK(claims_that_hold(findings) == all - 2);
}

} // namespace paper_claims_test
