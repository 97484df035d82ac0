#pragma once

#include "check/scene_report.h"
#include "study/curve.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace multipath {

/// The paper's numbers of one scene.
struct SceneFindings
{
    std::string name; ///< "4CHAIRS, lit upwards"
    std::uint32_t patches = 0;
    SceneReport report;
};

/// What the reproduction of the paper has found, for its report.
struct PaperFindings
{
    bool quick = false;
    std::vector<std::string> facts; ///< about the run: version, machine, date, duration
    SceneFindings five_cubes;
    SceneFindings four_chairs;
    SceneFindings four_chairs_up;
    std::map<std::string, Study> studies;        ///< by the name of their files without extension
    std::map<std::string, std::string> commands; ///< that made a file, by its name

    const Study& study(const std::string& name) const { return studies.at(name); }
};

/// The curve of a study with this method and sequence, and this line order if one is given. Throws std::out_of_range.
const Curve& curve_of(const Study& study, const std::string& method, const std::string& sequence,
                      const std::string& line_order = "", const std::string& pairing = "");

/// What the numbers say of a statement: undecided while their 95 % interval has room for it and for its contrary.
enum class Verdict { holds, undecided, differs };

std::string verdict_word(Verdict verdict);

/// A statement of the paper with what was found.
struct Claim
{
    std::string statement;
    std::string expected;
    std::string found;
    Verdict verdict = Verdict::differs;
    std::string remark; ///< what else there is to say; may be empty
};

/// The statements in the order of the paper.
std::vector<Claim> paper_claims(const PaperFindings& findings);

/// The same as lines for a terminal.
std::string claims_text(const std::vector<Claim>& claims);

} // namespace multipath
