// multipath COMMAND [OPTIONS] ARGUMENTS: finds the command, runs it, and turns exceptions into one line on stderr and
// an exit code.

#include "base/errors.h"
#include "base/platform/machine.h"
#include "base/platform/process.h"
#include "base/text_format.h"
#include "cli/files/interrupt.h"
#include "cli/files/standard_streams.h"
#include "cli/options/help_text.h"
#include "cli/version.h"
#include "commands/commands.h"
#include "commands/options/scene_options.h"
#include "parallel/instruction_set.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace multipath;

constexpr const char* out_of_memory = "out of memory; fewer patches need less (a larger --patch-size)";

int run(const std::vector<Command>& commands, const std::vector<std::string>& words)
{
    if (!kernel_limit_is_known())
        throw UsageError("MULTIPATH_KERNELS: expected one of " + join(instruction_sets(), ", "));
    if (words[0] == "--version") {
        print(version_text());
        return exit_done;
    }
    if (words[0] == "--help" || words[0] == "-h") {
        print(program_help(tables_of(commands), help_topics()));
        return exit_done;
    }
    const Command command = command_named(words[0]);
    const CommandLine line(command.table, {words.begin() + 1, words.end()});
    if (line.has("help")) {
        print(help_text(command.table));
        return exit_done;
    }
    return command.run(line);
}

int failed(const std::string& message)
{
    print_note("multipath: " + message + "\n");
    return exit_failed;
}

int wrong_usage(const std::string& message, const std::vector<Command>& commands, const std::string& command)
{
    const bool known =
        std::any_of(commands.begin(), commands.end(), [&](const Command& c) { return c.table.name == command; });
    failed(message + "\ntry 'multipath " + (known ? command + " " : "") + "--help'");
    return exit_usage;
}

} // namespace

int main(int argc, char** argv)
{
    keep_freed_memory();
    prepare_process();
    end_at_interrupts();
    const std::vector<Command> all = commands();
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.empty()) {
        std::fputs(program_help(tables_of(all), help_topics()).c_str(), stderr);
        return exit_usage;
    }
    try {
        return run(all, words);
    } catch (const UsageError& error) {
        return wrong_usage(error.what(), all, words[0]);
    } catch (const SettingsError& error) {
        return wrong_usage(error.what() + advice_text(error.advice), all, words[0]);
    } catch (const InputError& error) {
        return failed(error.what() + advice_text(error.advice));
    } catch (const ReaderGone&) {
        return exit_failed;
    } catch (const std::bad_alloc&) {
        return failed(out_of_memory);
    } catch (const std::length_error&) { // a vector or string larger than any memory
        return failed(out_of_memory);
    } catch (const std::exception& error) {
        return failed(error.what());
    }
}
