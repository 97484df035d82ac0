#include "commands/paper_steps.h"

#include <iterator>
#include <sstream>

namespace multipath {

namespace {

/// Numbers of lines and executions of the studies, as words for their options.
struct Effort
{
    std::string slopes_from; ///< lines of Table 1 and Figures 3 and 4
    std::string slopes_to;
    std::string order_to; ///< lines of the study of the order of the lines; its bias shows only with many
    std::string shots_to; ///< lines of Figures 7 to 9, from 46875 on; 46875 * 2^5 = 1.5 million
    std::string reference_lines;
    std::string reuse_to; ///< lines of the curves of line reuse
    std::string replicates;
};

const Effort full_effort = {"2^15", "2^21", "2^22", "1.5M", "16M", "2^21", "6"};
const Effort quick_effort = {"2^14", "2^19", "2^20", "375k", "2M", "2^17", "3"};

/// Appends the step of a command line whose words are separated by spaces. FOLDER stands for the name of the folder,
/// which may contain spaces.
void add(std::vector<PaperStep>& list, const std::string& command, const std::vector<std::string>& outputs)
{
    std::istringstream words(command);
    list.push_back({{std::istream_iterator<std::string>(words), {}}, outputs});
}

/// Appends a study with a table and a plot as outputs.
void add_study(std::vector<PaperStep>& list, const std::string& name, const std::string& words)
{
    add(list, "study " + words, {name + ".csv", name + ".svg"});
}

/// The patch size that `study` chooses for this scene by default; `solve` would choose adaptive patches.
const std::string patches_of_4chairs = " --patch-size 0.25";

/// Section 3: sequences.
void add_sequences(std::vector<PaperStep>& list, const Effort& effort)
{
    const std::string few = "halton:2,7,3,5,halton:11,13,17,19,sobol";
    const std::string curves = " --methods first-shot --sequences random," + few + " --line-orders sequence";
    const std::string lines = " --from " + effort.slopes_from + " --to ";
    const std::string replicates = " --replicates " + effort.replicates;
    const std::string slopes = lines + effort.slopes_to + replicates;
    add(list, "points --figure 1", {"figure1.svg"});
    add(list, "points --figure 2", {"figure2.svg"});
    add_study(list, "figure3", "5cubes" + curves + slopes);
    add_study(list, "figure4", "4chairs" + curves + slopes);
    add_study(list, "order",
              "5cubes --patch-size 0.5 --methods first-shot --sequences " + few + " --line-orders sequence,shuffled" +
                  lines + effort.order_to + replicates);
    add_study(list, "pairs", "5cubes --methods first-shot --sequences halton,sobol --pairings 4d,2d" + slopes);
    const std::string picture =
        "solve 4chairs" + patches_of_4chairs + " --method first-shot --line-order sequence --lines ";
    const std::string flat = " --shading flat --size 400x300";
    add(list, picture + "266000 --sequence random" + flat, {"figure5a.png"});
    add(list, picture + "266000 --sequence halton:11,13,17,19" + flat, {"figure5b.png"});
    add(list, picture + "532000 --sequence random" + flat, {"figure5c.png"});
    add(list, picture + "532000 --sequence halton:11,13,17,19" + flat, {"figure5d.png"});
}

/// Section 4: the extended first shot. The errors are measured against two references: the best that the program can
/// compute, and one like the paper's.
void add_shots(std::vector<PaperStep>& list, const Effort& effort)
{
    const auto picture = [&](const std::string& method, const std::string& file) {
        add(list,
            "solve 4chairs-up" + patches_of_4chairs + " --method " + method +
                " --lines 1.5M --sequence random --shading flat --size 400x300",
            {file});
    };
    picture("first-shot", "figure6a.png");
    picture("extended", "figure6b.png");
    picture("local", "figure6c.png");

    const std::string random =
        " --sequences random --from 46875 --to " + effort.shots_to + " --replicates " + effort.replicates;
    const std::string all = " --methods first-shot,extended,local" + random;
    add_study(list, "figure7", "4chairs-up" + all);
    add_study(list, "figure8", "4chairs-up --methods extended,local" + random);
    add_study(list, "figure9", "4chairs" + all);

    const std::string reference =
        patches_of_4chairs + " --method local --sequence random --replicates 4 --lines " + effort.reference_lines;
    add(list, "solve 4chairs-up" + reference, {"reference-up.csv"});
    add(list, "solve 4chairs" + reference, {"reference-down.csv"});
    add(list, "study 4chairs-up" + all + " --reference FOLDER/reference-up.csv", {"figure7-local.csv"});
    add(list, "study 4chairs" + all + " --reference FOLDER/reference-down.csv", {"figure9-local.csv"});
}

/// Line reuse, which goes beyond the paper, against lines and against seconds.
void add_reuse(std::vector<PaperStep>& list, const Effort& effort)
{
    const std::string lines =
        " --from " + effort.slopes_from + " --to " + effort.reuse_to + " --replicates " + effort.replicates;
    for (const std::string scene : {"5cubes", "4chairs", "4chairs-up"}) {
        const std::string curves = scene + " --methods extended,reuse --sequences random,sobol-owen";
        add_study(list, "reuse-" + scene, curves + lines);
        add(list, "study " + curves + " --against seconds" + lines, {"reuse-" + scene + "-seconds.svg"});
    }
}

} // namespace

std::string typed(const PaperStep& step)
{
    std::string text = "multipath";
    for (const std::string& word : step.words)
        text += " " + word;
    for (const std::string& output : step.outputs)
        text += " -o " + output;
    return text;
}

std::vector<PaperStep> paper_steps(bool quick, const std::string& folder)
{
    const Effort& effort = quick ? quick_effort : full_effort;
    std::vector<PaperStep> list;
    add_sequences(list, effort);
    add_shots(list, effort);
    add_reuse(list, effort);
    for (PaperStep& step : list)
        for (std::string& word : step.words)
            if (word.rfind("FOLDER/", 0) == 0)
                word.replace(0, 6, folder);
    return list;
}

} // namespace multipath
