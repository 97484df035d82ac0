#include "export/file_bytes.h"

#include "scene/input_error.h"

#include <cerrno>
#include <fcntl.h>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace multipath {

namespace {

/// An open file, to be closed.
class Descriptor
{
public:
    explicit Descriptor(const std::string& path) : number_(open(path.c_str(), O_RDONLY | O_CLOEXEC))
    {
        if (number_ < 0)
            fail();
    }
    ~Descriptor() { close(number_); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int number() const { return number_; }
    [[noreturn]] static void fail() { throw std::runtime_error(std::generic_category().message(errno)); }

private:
    int number_;
};

/// All bytes of a file that cannot be mapped, such as a pipe, up to a limit.
std::vector<char> read_all(const Descriptor& file)
{
    constexpr std::size_t most = std::size_t{1} << 30;
    std::vector<char> bytes;
    for (;;) {
        constexpr std::size_t more = 1u << 20;
        const std::size_t length = bytes.size();
        bytes.resize(length + more);
        const ssize_t got = read(file.number(), bytes.data() + length, more);
        if (got < 0)
            Descriptor::fail();
        bytes.resize(length + static_cast<std::size_t>(got));
        if (got == 0)
            return bytes;
        if (bytes.size() > most)
            throw std::runtime_error("more than 1 GiB from a pipe; expected a file");
    }
}

} // namespace

FileBytes::FileBytes(const std::string& path)
{
    const Descriptor file(path);
    struct stat status = {};
    if (fstat(file.number(), &status) != 0)
        Descriptor::fail();
    if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode))
        throw std::runtime_error("a device; expected a file or a pipe");
    if (!S_ISREG(status.st_mode) || status.st_size == 0) {
        *this = FileBytes(read_all(file));
        return;
    }
    size_ = static_cast<std::size_t>(status.st_size);
    void* const mapped = mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file.number(), 0);
    if (mapped == MAP_FAILED)
        Descriptor::fail();
    const std::size_t size = size_;
    owner_ =
        std::shared_ptr<const void>(mapped, [size](const void* memory) { munmap(const_cast<void*>(memory), size); });
    data_ = static_cast<const char*>(mapped);
}

FileBytes::FileBytes(std::vector<char> bytes)
{
    const auto kept = std::make_shared<const std::vector<char>>(std::move(bytes));
    data_ = kept->data();
    size_ = kept->size();
    owner_ = kept;
}

std::string bytes_of_file(const std::string& path)
{
    try {
        return std::string(FileBytes(path).view());
    } catch (const std::runtime_error& error) {
        throw InputError(path + ": cannot be read: " + error.what());
    }
}

} // namespace multipath
