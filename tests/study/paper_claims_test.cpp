// The statements are judged from the numbers: findings that agree with the paper make all of them hold, and each is
// overturned by a finding against it.

#include "study/paper_findings.h"

#include <cmath>
#include <doctest/doctest.h>
#include <functional>

using namespace multipath;

namespace {

/// relative MSE = level * (lines / 2^15)^slope, with a little scatter, so that intervals are not of width 0.
Curve law_curve(const CurveKind& kind, double level, double slope)
{
    Curve curve{kind, {}, {}};
    for (int k = 0; k < 7; ++k) {
        CurvePoint point;
        point.lines = std::uint64_t{1} << (15 + k);
        point.relative = level * std::exp2(slope * k) * (k % 2 == 0 ? 1.01 : 0.99);
        point.relative_error = 0.01 * point.relative;
        curve.points.push_back(point);
    }
    curve.law = fit(curve.points);
    return curve;
}

CurveKind kind(const char* method, const char* sequence, const char* order = "sequence", const char* pairing = "4d")
{
    return {method, sequence, pairing, "sphere", order};
}

Study sequences_study(double sobol)
{
    Study study;
    study.curves = {law_curve(kind("first-shot", "random"), 0.03, -1.0),
                    law_curve(kind("first-shot", "halton:2,7,3,5"), 0.03, -1.1),
                    law_curve(kind("first-shot", "halton:11,13,17,19"), 0.03, -1.1),
                    law_curve(kind("first-shot", "sobol"), 0.03, sobol)};
    return study;
}

Study shots_study(double first_shot, double extended, double local)
{
    Study study;
    study.curves = {law_curve(kind("first-shot", "random"), first_shot, -1.0),
                    law_curve(kind("extended", "random"), extended, -1.0),
                    law_curve(kind("local", "random"), local, -1.0)};
    return study;
}

PaperFindings agreeing()
{
    PaperFindings f;
    f.studies["figure3"] = sequences_study(-1.10);
    f.studies["figure4"] = sequences_study(-1.12);
    for (const char* order : {"sequence", "shuffled"})
        for (const char* bases : {"halton:2,7,3,5", "halton:11,13,17,19"}) {
            const bool flat = std::string(order) == "sequence" && std::string(bases) == "halton:11,13,17,19";
            f.studies["order"].curves.push_back(law_curve(kind("first-shot", bases, order), 0.01, flat ? -0.85 : -1.1));
        }
    for (const char* pairing : {"4d", "2d"})
        f.studies["pairs"].curves.push_back(law_curve(kind("first-shot", "sobol", "shuffled", pairing), 0.1,
                                                      pairing == std::string("4d") ? -1.1 : 0.0));
    f.studies["figure7"] = f.studies["figure8"] = shots_study(0.5, 0.06, 0.05);
    f.studies["figure9"] = shots_study(0.046, 0.042, 0.05);
    f.studies["figure9-coarse"] = f.studies["figure9-fine"] = f.studies["figure9"];
    f.four_chairs_up.report.ratio_first_shot = 0.409;
    f.four_chairs.report.ratio_first_shot = 0.853;
    f.four_chairs.report.ratio_extended = 1.066;
    return f;
}

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
    const PaperFindings findings = agreeing();
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
    PaperFindings findings = agreeing();
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
    PaperFindings findings = agreeing();
    const int all = claims_that_hold(findings);
    findings.studies["figure3"] = sequences_study(-1.21); // below -1, but 0.11 off
    CHECK(claims_that_hold(findings) == all - 1);
    findings.studies["figure3"] = sequences_study(-1.004); // within 0.1, but not below -1 for sure
    CHECK(claims_that_hold(findings) == all - 1);
}
