#include "commands/machine.h"

#include <array>
#include <ctime>
#include <fstream>
#include <sys/utsname.h>

namespace multipath {

std::string processor_name()
{
    std::ifstream facts("/proc/cpuinfo"); // Linux
    for (std::string line; std::getline(facts, line);)
        if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos)
            return line.substr(line.find(": ") + 2);
    utsname names{};
    return uname(&names) == 0 ? names.machine : "unknown";
}

std::string today()
{
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    std::array<char, 16> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d", &utc);
    return text.data();
}

} // namespace multipath
