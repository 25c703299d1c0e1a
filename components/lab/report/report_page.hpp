// A report as a file that anybody can open and pass on.
#pragma once

#include <filesystem>
#include <string>

#include "components/lab/report/document.hpp"

namespace bw {

/// False where this program was built without the page (Node.js): then it can draw no report.
bool can_draw_reports();

/// Before anything is reckoned: throws std::runtime_error that names `option` where this program has no page.
void require_report_page(const std::string& option);

/// The document and the code that draws it, one HTML file that needs nothing else. It appears whole or not at
/// all. Throws std::runtime_error: no page, no room.
void write_report_page(const report::Document& document, const std::filesystem::path& html);

}  // namespace bw
