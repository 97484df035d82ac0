#include "image/camera_file.h"

#include "base/file_bytes.h"
#include "scene/text/text_lines.h"
#include "scene/text/text_words.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>

namespace multipath {

namespace {

/// Parser for the subset of JSON that a view needs: one object whose values are numbers or lists of three numbers.
class CameraParser
{
public:
    CameraParser(const std::string& path, std::string_view text) : path_(path), text_(text) {}

    Camera parse()
    {
        Camera camera;
        std::set<std::string> keys;
        expect('{', "an object { ... } with `eye` and `target`");
        for (bool more = next() != '}'; more; more = take(',')) {
            const std::string key = string();
            if (!keys.insert(key).second)
                fail("`" + key + "` is given again");
            expect(':', "a colon after " + in_quotes(key));
            if (key == "eye")
                camera.eye = point(key);
            else if (key == "target")
                camera.target = point(key);
            else if (key == "up")
                camera.up = point(key);
            else if (key == "fov")
                camera.field_of_view = angle();
            else
                fail("unknown key " + in_quotes(key) + ", expected `eye`, `target`, `up` or `fov`");
        }
        expect('}', "a comma or the end of the object");
        if (next() != '\0' || position_ < text_.size())
            fail("more text after the view, expected the end of the file");
        for (const char* needed : {"eye", "target"})
            if (keys.count(needed) == 0)
                refuse({path_, 0},
                       "no `" + std::string(needed) + "`, expected {\"eye\": [x, y, z], \"target\": [x, y, z]}");
        if (camera.eye == camera.target)
            refuse({path_, 0}, "the camera looks at where it stands, expected another `target`");
        if (length(cross(camera.target - camera.eye, camera.up)) == 0.0)
            refuse({path_, 0}, "the camera looks along `up`, expected another direction");
        return camera;
    }

private:
    [[noreturn]] void fail(const std::string& problem) const
    {
        const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(position_, text_.size()));
        refuse({path_, static_cast<std::uint32_t>(1 + std::count(text_.begin(), end, '\n'))}, problem);
    }

    /// Skips white space and returns the next character; 0 at the end.
    char next()
    {
        position_ = std::min(text_.find_first_not_of(" \t\n\v\f\r", position_), text_.size());
        return position_ < text_.size() ? text_[position_] : '\0';
    }

    bool take(char c)
    {
        const bool found = next() == c;
        position_ += found ? 1 : 0;
        return found;
    }

    void expect(char c, const std::string& what)
    {
        if (!take(c))
            fail("expected " + what);
    }

    std::string string()
    {
        expect('"', "a key in double quotes");
        const std::size_t end = text_.find('"', position_);
        if (end == std::string_view::npos)
            fail("a key has no end, expected a double quote");
        std::string result(text_.substr(position_, end - position_));
        position_ = end + 1;
        return result;
    }

    double number(const std::string& key)
    {
        next();
        const std::size_t end = std::min(text_.find_first_of(",]} \t\r\n", position_), text_.size());
        const std::string_view word = text_.substr(position_, end - position_);
        const std::optional<double> value = to_number(word);
        constexpr double most = 1e9; // as in OBJ files
        if (!value || !(*value >= -most && *value <= most))
            fail("`" + key + "`: expected a number, got " + in_quotes(word));
        position_ = end;
        return *value;
    }

    Vec3 point(const std::string& key)
    {
        std::array<double, 3> numbers{};
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            expect(k == 0 ? '[' : ',', "three numbers [x, y, z] of `" + key + "`");
            numbers[k] = number(key);
        }
        expect(']', "three numbers [x, y, z] of `" + key + "`");
        return {numbers[0], numbers[1], numbers[2]};
    }

    double angle()
    {
        const double degrees = number("fov");
        if (!(degrees >= 1.0 && degrees <= 179.0))
            fail("`fov`: expected 1 to 179 degrees");
        return degrees;
    }

    const std::string& path_;
    std::string_view text_;
    std::size_t position_ = 0;
};

} // namespace

Camera read_camera_file(const std::string& path)
{
    std::string text = bytes_of_file(path);
    if (text.compare(0, 3, "\xef\xbb\xbf") == 0) // byte order mark
        text.erase(0, 3);
    return CameraParser(path, text).parse();
}

} // namespace multipath
