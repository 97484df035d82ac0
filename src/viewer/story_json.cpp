#include "viewer/story_json.h"

#include "scene/scene.h"
#include "scene/text_format.h"

#include <cstdlib>

namespace multipath {

namespace {

double six_digits(double value)
{
    return std::strtod(format("%.6g", value).c_str(), nullptr);
}

void append(std::vector<double>& numbers, Vec3 point)
{
    for (const double x : {point.x, point.y, point.z})
        numbers.push_back(six_digits(x));
}

/// One number where the power_channels agree.
std::vector<double> power_channels(Rgb power)
{
    const Rgb p = {six_digits(power.r), six_digits(power.g), six_digits(power.b)};
    return p.r == p.g && p.g == p.b ? std::vector<double>{p.r} : std::vector<double>{p.r, p.g, p.b};
}

JsonObject transfer_json(const ViewerTransfer& transfer)
{
    JsonObject json;
    json.count("stretch", transfer.stretch);
    json.count("from", transfer.from);
    if (transfer.to == Scene::no_patch)
        json.null("to");
    else
        json.count("to", transfer.to);
    json.numbers("forecast", power_channels(transfer.forecast));
    json.numbers("held", power_channels(transfer.held));
    json.numbers("counted", power_channels(transfer.counted));
    return json;
}

JsonObject line_json(const ViewerLine& line)
{
    std::vector<double> points;
    std::string bold;
    for (const DrawnStretch& stretch : line.shape.stretches) {
        if (points.empty())
            append(points, stretch.from);
        append(points, stretch.to);
        bold += stretch.bold ? '1' : '0';
    }
    std::vector<double> meetings;
    for (const Vec3& meeting : line.shape.meetings)
        append(meetings, meeting);
    std::vector<JsonObject> transfers;
    for (const ViewerTransfer& transfer : line.transfers)
        transfers.push_back(transfer_json(transfer));
    JsonObject json;
    json.text("label", line.shape.label);
    json.numbers("points", points);
    json.text("bold", bold);
    json.numbers("meetings", meetings);
    json.objects("transfers", transfers);
    return json;
}

} // namespace

JsonObject story_json(const ViewerChapter& chapter)
{
    std::vector<JsonObject> lines;
    for (const ViewerLine& line : chapter.lines)
        lines.push_back(line_json(line));
    JsonObject json;
    json.text("title", chapter.title);
    json.text("note", chapter.note);
    json.objects("lines", lines);
    return json;
}

} // namespace multipath
