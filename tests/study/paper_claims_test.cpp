// The statements are judged from the numbers: findings that agree with the paper make all of them hold, and each is
// overturned by a finding against it.

#include "study/agreeing_findings.h"

#include <doctest/doctest.h>
#include <functional>

using namespace multipath;

namespace {

int claims_that_hold(const PaperFindings& findings)
{
    int count = 0;
    for (const Claim& claim : paper_claims(findings))
        count += claim.verdict == Verdict::holds ? 1 : 0;
    return count;
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

// Both errors are known to 1 %, so their ratio to 1.4 %: 0.99 is within two standard errors of 1, 0.95 is not.
TEST_CASE("a ratio within two standard errors of its limit decides nothing")
{
    PaperFindings findings = agreeing_findings();
    for (const auto& [first_shot, verdict] :
         {std::pair{0.0475, Verdict::holds}, {0.0495, Verdict::undecided}, {0.0530, Verdict::differs}}) {
        findings.studies["figure9"] = shots_study(first_shot, 0.045, 0.05);
        for (const Claim& claim : paper_claims(findings))
            if (claim.statement.find("beat local") != std::string::npos)
                CHECK(claim.verdict == verdict);
    }
}

TEST_CASE("Sobol's slopes are judged against -1 and against the printed ones")
{
    PaperFindings findings = agreeing_findings();
    const int all = claims_that_hold(findings);
    findings.studies["figure3"] = sequences_study(-1.21); // below -1, but 0.11 off
    CHECK(claims_that_hold(findings) == all - 1);
    findings.studies["figure3"] = sequences_study(-1.004); // within 0.1, but not below -1 for sure
    CHECK(claims_that_hold(findings) == all - 1);
}
