#include "commands/machine.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <limits>
#include <sys/utsname.h>
#include <unistd.h>

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

double machine_memory()
{
    const long pages = sysconf(_SC_PHYS_PAGES);
    double bytes = pages > 0 ? static_cast<double>(pages) * static_cast<double>(sysconf(_SC_PAGESIZE))
                             : std::numeric_limits<double>::infinity();
    // Linux's control groups, versions 2 and 1; "max" where there is no limit.
    for (const char* limit : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
        std::ifstream file(limit);
        if (double allowed = 0.0; file >> allowed && allowed > 0.0)
            bytes = std::min(bytes, allowed);
    }
    return bytes;
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
