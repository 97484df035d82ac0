#include "cli/files/standard_streams.h"

#include "cli/files/output_file.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace multipath {

namespace {

void replace_controls(std::string& text)
{
    const auto is_control = [](unsigned char c) { return (c < 0x20 && c != '\n' && c != '\t') || c == 0x7f; };
    std::replace_if(text.begin(), text.end(), is_control, '?');
}

} // namespace

void prepare_standard_streams()
{
    // Opened for the opposite direction: reading or writing fails as on a closed stream.
    constexpr int modes[] = {O_WRONLY, O_RDONLY, O_RDONLY};
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(descriptor, F_GETFD) < 0)
            (void)open("/dev/null", modes[descriptor]); // gets the lowest free number: this one
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

void print(std::string text)
{
    replace_controls(text);
    OutputFile output("-");
    output.write(text);
    output.commit();
}

void print_note(std::string text)
{
    replace_controls(text);
    std::fputs(text.c_str(), stderr);
}

} // namespace multipath
