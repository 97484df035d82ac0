// Any words, one to a line, behind the name of any command: options within their limits, or a UsageError. The first
// byte chooses the command.

#include "base/errors.h"
#include "cli/options/command_line.h"
#include "cli/options/number_text.h"
#include "commands/commands.h"
#include "commands/options/method_options.h"
#include "commands/options/picture_options.h"
#include "commands/solve/accuracy.h"
#include "commands/solve/formats.h"
#include "fuzz_file.h"

#include <cmath>
#include <cstdlib>
#include <sstream>

using namespace multipath;

namespace {

void require(bool promise)
{
    if (!promise)
        std::abort();
}

template <class Read>
void unless_refused(const Read& read)
{
    try {
        read();
    } catch (const UsageError&) {
    } catch (const InputError&) { // a picture too large for the memory
    }
}

void read_numbers(const std::string& word)
{
    unless_refused([&] { require(read_count("--n", word) <= largest_count); });
    unless_refused([&] { require(std::isfinite(read_real("--x", word, -1e300, 1e300))); });
    unless_refused([&] { require(read_positive("--x", word) > 0.0); });
    unless_refused([&] { require(read_share("--x", word) <= 1.0); });
    unless_refused([&] { require(read_bytes("--x", word) >= 1); });
    unless_refused([&] { require(read_seconds("--x", word) > 0.0); });
    unless_refused([&] { require(std::isfinite(read_vec3("--x", word).x)); });
    unless_refused([&] { require(read_pixel_size("--x", word, 16384).width >= 1); });
    unless_refused([&] { (void)kind_of(word); });
}

void read_options(const CommandLine& line)
{
    if (line.has("help"))
        return;
    if (line.knows("method")) {
        unless_refused([&] { require_options_with_effect(line); });
        unless_refused([&] { checked_sequence_name(read_solve_options(line, line.knows("of") ? "of" : "lines")); });
    }
    if (line.knows("replicates") && line.knows("tolerance"))
        unless_refused([&] { require(read_accuracy(line).replicates >= 1); });
    if (line.knows("exposure") && line.knows("memory")) // without, the words are handed on to `solve`
        unless_refused([&] { read_picture_options(line, 1); });
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const std::vector<Command> all = commands();
    if (size == 0)
        return 0;
    const std::string text(fuzz_text(data + 1, size - 1));
    std::vector<std::string> words;
    std::istringstream lines(text);
    for (std::string word; std::getline(lines, word);)
        words.push_back(word);
    for (const std::string& word : words)
        read_numbers(word);
    unless_refused([&] { read_options(CommandLine(all[data[0] % all.size()].table, words)); });
    return 0;
}
