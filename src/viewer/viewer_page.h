#pragma once

#include "scene/scene.h"
#include "viewer/viewer_content.h"

#include <string>
#include <string_view>

namespace multipath {

/// How a page begins; no other HTML file of this program does.
constexpr const char* viewer_page_begin = "<!DOCTYPE html>\n<html lang=\"en\" class=\"multipath-viewer\">\n";

/// Where the data of the room stand in a page, and where they end.
constexpr const char* room_data_begin = "<script type=\"application/json\" id=\"room\">";
constexpr const char* room_data_end = "</script>";

/// A page (HTML) to walk through the solved room in a browser: complete in itself, it loads nothing.
std::string viewer_page(const Scene& scene, const ViewerContent& content);

/// The text of a file of the folder src/viewer/page, by its name; the Makefile puts the files into the program. Throws
/// std::logic_error for an unknown name.
std::string_view page_file(std::string_view name);

} // namespace multipath
