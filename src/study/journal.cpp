#include "study/journal.h"

#include "image/checksum.h"

#include <array>
#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <unistd.h>

namespace multipath {

namespace {

std::string key_text(const ExecutionKey& key)
{
    return key.curve + "\t" + std::to_string(key.lines) + "\t" + std::to_string(key.number);
}

std::string checksum_text(const std::string& text)
{
    std::array<char, 16> hex{};
    std::snprintf(hex.data(), hex.size(), "\t%08" PRIx32, crc32(text));
    return hex.data();
}

std::string values_text(const Execution& e)
{
    std::array<char, 192> text{};
    std::snprintf(text.data(), text.size(), "\t%" PRIu64 "\t%" PRIu64 "\t%.17g\t%.17g\t%.17g", e.local_lines,
                  e.global_lines, e.mean_square, e.relative, e.seconds);
    return text.data();
}

/// Splits a record into its key and its values. Empty for one that is damaged.
std::optional<std::pair<std::string, Execution>> parsed(const std::string& line)
{
    constexpr std::size_t sum_size = 9;
    constexpr int value_count = 5;
    if (line.size() < sum_size ||
        checksum_text(line.substr(0, line.size() - sum_size)) != line.substr(line.size() - sum_size))
        return {};
    std::size_t end = line.size() - sum_size;
    std::size_t values = end;
    for (int field = 0; field < value_count; ++field) {
        if (values == 0 || (values = line.rfind('\t', values - 1)) == std::string::npos)
            return {};
    }
    Execution e;
    std::istringstream numbers(line.substr(values, end - values));
    numbers.imbue(std::locale::classic());
    if (!(numbers >> e.local_lines >> e.global_lines >> e.mean_square >> e.relative >> e.seconds))
        return {};
    return std::pair{line.substr(0, values), e};
}

std::string file_text(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

} // namespace

Journal::Journal(const std::string& path, const std::string& identity) : path_(path)
{
    read(file_text(path), identity);
    const bool fresh = executions_.empty();
    descriptor_ = open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | (fresh ? O_TRUNC : 0), 0666);
    if (descriptor_ < 0)
        throw std::runtime_error("cannot write " + path + ": " + std::strerror(errno));
    if (fresh)
        append(identity);
    else
        append(""); // ends what may have been cut off in the middle of a line
}

Journal::~Journal()
{
    if (descriptor_ >= 0)
        close(descriptor_);
}

void Journal::read(const std::string& text, const std::string& identity)
{
    std::istringstream lines(text);
    std::string line;
    if (!std::getline(lines, line) || line != identity)
        return;
    while (std::getline(lines, line))
        if (const auto record = parsed(line))
            executions_[record->first] = record->second;
}

void Journal::append(const std::string& line)
{
    const std::string bytes = line + "\n";
    for (std::size_t done = 0; done < bytes.size();) { // a disk that is full takes a part, and refuses the next
        const ssize_t written = write(descriptor_, bytes.data() + done, bytes.size() - done);
        if (written < 0 && errno != EINTR)
            throw std::runtime_error("cannot write " + path_ + ": " + std::strerror(errno));
        done += written < 0 ? 0 : static_cast<std::size_t>(written);
    }
}

std::optional<Execution> Journal::find(const ExecutionKey& key) const
{
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = executions_.find(key_text(key));
    return found == executions_.end() ? std::nullopt : std::optional(found->second);
}

void Journal::add(const ExecutionKey& key, const Execution& execution)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::string text = key_text(key) + values_text(execution);
    executions_[key_text(key)] = execution;
    if (descriptor_ >= 0)
        append(text + checksum_text(text));
}

} // namespace multipath
