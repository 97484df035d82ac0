#include "commands/forwarded_options.h"

namespace multipath {

std::vector<std::string> forwarded_options(const CommandTable& table, const CommandLine& line)
{
    std::vector<std::string> words;
    for (const OptionGroup& group : table.groups)
        for (const Option& option : group.options)
            for (const std::string& value : line.all(option.name))
                words.push_back("--" + std::string(option.name) + (option.argument.empty() ? "" : "=" + value));
    return words;
}

OptionGroup solution_output_group()
{
    return {"Output",
            {{"output", 'o', "FILE", "",
              "Where to write; by extension .ppm, .png, .pfm (pictures), .ply, .glb, .obj (meshes whose vertices "
              "have the light as colours), .csv (one row per patch), .html (a page to walk through the room in a "
              "browser) or .state (all of the run, to go on or render again). '-' writes a PPM to standard output. "
              "Without it, a .ppm and a .png with the name of the input are written here.",
              true},
             {"json", 0, "", "", "Print a machine-readable summary on standard output."},
             {"quiet", 'q', "", "", "Print nothing on stderr but errors."},
             {"verbose", 'v', "", "", "Also show where the power is after every stage."},
             {"progress", 0, "WHEN", "auto", "Show progress on stderr.", false, {"auto", "always", "never"}}}};
}

std::vector<std::string> default_outputs(const std::string& path)
{
    std::string name = path.substr(path.find_last_of('/') + 1);
    const std::size_t dot = name.find_last_of('.');
    if (dot != std::string::npos && dot > 0)
        name.resize(dot);
    return {name + ".ppm", name + ".png"};
}

} // namespace multipath
