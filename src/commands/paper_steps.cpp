#include "commands/paper_steps.h"

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

Effort full_effort()
{
    return {"2^15", "2^21", "2^22", "1.5M", "16M", "2^21", "6"};
}

Effort quick_effort()
{
    return {"2^14", "2^19", "2^20", "375k", "2M", "2^17", "3"};
}

/// Builds the list of steps from command lines whose words are separated by spaces. SCENES and FOLDER stand for the
/// names of folders, which may contain spaces.
class StepList
{
public:
    StepList(std::string scenes, std::string folder) : scenes_(std::move(scenes)), folder_(std::move(folder)) {}

    void add(const std::string& command, const std::vector<std::string>& outputs)
    {
        PaperStep step{{}, outputs};
        std::istringstream stream(command);
        for (std::string word; stream >> word;)
            step.words.push_back(word.rfind("SCENES/", 0) == 0   ? scenes_ + word.substr(6)
                                 : word.rfind("FOLDER/", 0) == 0 ? folder_ + word.substr(6)
                                                                 : word);
        steps.push_back(step);
    }

    /// Adds a study with a table and a plot as outputs.
    void study(const std::string& name, const std::string& words)
    {
        add("study SCENES/" + words, {name + ".csv", name + ".svg"});
    }

    std::vector<PaperStep> steps;

private:
    std::string scenes_;
    std::string folder_;
};

/// The patch size that `study` chooses for this scene by default; `solve` would choose adaptive patches.
const std::string patches_of_4chairs = " --patch-size 0.25";

/// Section 3: sequences.
void add_sequences(StepList& list, const Effort& effort)
{
    const std::string few = "halton:2,7,3,5,halton:11,13,17,19,sobol";
    const std::string curves = " --methods first-shot --sequences random," + few + " --line-orders sequence";
    const std::string lines = " --from " + effort.slopes_from + " --to ";
    const std::string replicates = " --replicates " + effort.replicates;
    const std::string slopes = lines + effort.slopes_to + replicates;
    list.add("points --figure 1", {"figure1.svg"});
    list.add("points --figure 2", {"figure2.svg"});
    list.study("figure3", "5cubes.obj" + curves + slopes);
    list.study("figure4", "4chairs.obj" + curves + slopes);
    list.study("order", "5cubes.obj --patch-size 0.5 --methods first-shot --sequences " + few +
                            " --line-orders sequence,shuffled" + lines + effort.order_to + replicates);
    list.study("pairs", "5cubes.obj --methods first-shot --sequences halton,sobol --pairings 4d,2d" + slopes);
    const std::string picture =
        "solve SCENES/4chairs.obj" + patches_of_4chairs + " --method first-shot --line-order sequence --lines ";
    const std::string flat = " --shading flat --size 400x300";
    list.add(picture + "266000 --sequence random" + flat, {"figure5a.png"});
    list.add(picture + "266000 --sequence halton:11,13,17,19" + flat, {"figure5b.png"});
    list.add(picture + "532000 --sequence random" + flat, {"figure5c.png"});
    list.add(picture + "532000 --sequence halton:11,13,17,19" + flat, {"figure5d.png"});
}

/// Section 4: the extended first shot. The errors are measured against two references: the best that the program can
/// compute, and one like the paper's.
void add_shots(StepList& list, const Effort& effort)
{
    const auto picture = [&](const std::string& method, const std::string& file) {
        list.add("solve SCENES/4chairs-up.obj" + patches_of_4chairs + " --method " + method +
                     " --lines 1.5M --sequence random --shading flat --size 400x300",
                 {file});
    };
    picture("first-shot", "figure6a.png");
    picture("extended", "figure6b.png");
    picture("local", "figure6c.png");

    const std::string random =
        " --sequences random --from 46875 --to " + effort.shots_to + " --replicates " + effort.replicates;
    const std::string all = " --methods first-shot,extended,local" + random;
    list.study("figure7", "4chairs-up.obj" + all);
    list.study("figure8", "4chairs-up.obj --methods extended,local" + random);
    list.study("figure9", "4chairs.obj" + all);

    const std::string reference =
        patches_of_4chairs + " --method local --sequence random --replicates 4 --lines " + effort.reference_lines;
    list.add("solve SCENES/4chairs-up.obj" + reference, {"reference-up.csv"});
    list.add("solve SCENES/4chairs.obj" + reference, {"reference-down.csv"});
    list.add("study SCENES/4chairs-up.obj" + all + " --reference FOLDER/reference-up.csv", {"figure7-local.csv"});
    list.add("study SCENES/4chairs.obj" + all + " --reference FOLDER/reference-down.csv", {"figure9-local.csv"});
    list.add("study SCENES/4chairs.obj" + all + " --patch-size 0.5", {"figure9-coarse.csv"});
    list.add("study SCENES/4chairs.obj" + all + " --patch-size 0.15", {"figure9-fine.csv"});
}

/// Line reuse, which goes beyond the paper, against lines and against seconds.
void add_reuse(StepList& list, const Effort& effort)
{
    const std::string lines =
        " --from " + effort.slopes_from + " --to " + effort.reuse_to + " --replicates " + effort.replicates;
    for (const std::string scene : {"5cubes", "4chairs", "4chairs-up"}) {
        const std::string curves = scene + ".obj --methods extended,reuse --sequences random,sobol-owen";
        list.study("reuse-" + scene, curves + lines);
        list.add("study SCENES/" + curves + " --against seconds" + lines, {"reuse-" + scene + "-seconds.svg"});
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

std::vector<PaperStep> paper_steps(bool quick, const std::string& scenes, const std::string& folder)
{
    const Effort effort = quick ? quick_effort() : full_effort();
    StepList list(scenes, folder);
    add_sequences(list, effort);
    add_shots(list, effort);
    add_reuse(list, effort);
    return list.steps;
}

} // namespace multipath
