#include "cli/files/standard_streams.h"

#include "cli/files/output_file.h"

#include <algorithm>
#include <cstdio>

namespace multipath {

namespace {

void replace_controls(std::string& text)
{
    const auto is_control = [](unsigned char c) { return (c < 0x20 && c != '\n' && c != '\t') || c == 0x7f; };
    std::replace_if(text.begin(), text.end(), is_control, '?');
}

} // namespace

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
