#include "cli/files/standard_streams.h"

#include "base/text_format.h"
#include "cli/files/output_file.h"

#include <cstdio>

namespace multipath {

void print(std::string_view text)
{
    OutputFile output("-");
    output.write(without_controls(text, "\n\t"));
    output.commit();
}

void print_note(std::string_view text)
{
    std::fputs(without_controls(text, "\n\t").c_str(), stderr);
}

} // namespace multipath
