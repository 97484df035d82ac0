#pragma once

#include "study/report/paper_claims.h"

#include <cmath>
#include <cstdint>
#include <string>

// Findings for tests of what is said of them.

namespace multipath {

/// relative MSE = level * (lines / 2^15)^slope, with a little scatter, so that intervals are not of width 0.
inline Curve law_curve(const CurveKind& kind, double level, double slope)
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

inline CurveKind kind(const char* method, const char* sequence, const char* order = "sequence",
                      const char* pairing = "4d")
{
    return {method, sequence, pairing, "sphere", order};
}

inline Study sequences_study(double sobol)
{
    Study study;
    study.executions = 6;
    study.curves = {law_curve(kind("first-shot", "random"), 0.03, -1.0),
                    law_curve(kind("first-shot", "halton:2,7,3,5"), 0.03, -1.1),
                    law_curve(kind("first-shot", "halton:11,13,17,19"), 0.03, -1.1),
                    law_curve(kind("first-shot", "sobol"), 0.03, sobol)};
    return study;
}

inline Study shots_study(double first_shot, double extended, double local)
{
    Study study;
    study.executions = 6;
    study.curves = {law_curve(kind("first-shot", "random"), first_shot, -1.0),
                    law_curve(kind("extended", "random"), extended, -1.0),
                    law_curve(kind("local", "random"), local, -1.0)};
    return study;
}

/// All that the report of the paper takes, with numbers like the paper's.
inline PaperFindings agreeing_findings()
{
    PaperFindings f;
    f.studies["figure3"] = sequences_study(-1.10);
    f.studies["figure4"] = sequences_study(-1.12);
    for (const char* order : {"sequence", "shuffled"})
        for (const char* name : {"halton:2,7,3,5", "halton:11,13,17,19", "sobol"}) {
            const bool flat = std::string(order) == "sequence" && std::string(name) == "halton:11,13,17,19";
            f.studies["order"].curves.push_back(law_curve(kind("first-shot", name, order), 0.01, flat ? -0.85 : -1.1));
        }
    f.studies["pairs"].executions = 6;
    for (const char* pairing : {"4d", "2d"})
        f.studies["pairs"].curves.push_back(law_curve(kind("first-shot", "sobol", "shuffled", pairing), 0.1,
                                                      pairing == std::string("4d") ? -1.1 : 0.0));
    f.studies["figure7"] = f.studies["figure8"] = shots_study(0.5, 0.06, 0.05);
    f.studies["figure9"] = shots_study(0.046, 0.042, 0.05);
    f.studies["figure9-coarse"] = f.studies["figure9-fine"] = f.studies["figure9"];
    f.studies["figure7-local"] = f.studies["figure7"];
    f.studies["figure9-local"] = f.studies["figure9"];
    for (const char* scene : {"reuse-5cubes", "reuse-4chairs", "reuse-4chairs-up"})
        f.studies[scene].curves = {law_curve(kind("extended", "sobol-owen"), 0.01, -1.1),
                                   law_curve(kind("reuse", "sobol-owen"), 0.0001, -1.5)};
    f.four_chairs_up.report.ratio_first_shot = 0.409;
    f.four_chairs.report.ratio_first_shot = 0.853;
    f.four_chairs.report.ratio_extended = 1.066;
    return f;
}

} // namespace multipath
