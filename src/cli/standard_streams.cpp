#include "cli/standard_streams.h"

#include "cli/output_file.h"

#include <csignal>
#include <fcntl.h>
#include <unistd.h>

namespace multipath {

void prepare_standard_streams()
{
    // Opened the wrong way round: what a closed stream would refuse, this refuses as well.
    constexpr int modes[] = {O_WRONLY, O_RDONLY, O_RDONLY};
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(descriptor, F_GETFD) < 0)
            (void)open("/dev/null", modes[descriptor]); // the lowest number that is free: this one
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

void print(std::string_view text)
{
    OutputFile output("-");
    output.write(text);
    output.commit();
}

} // namespace multipath
