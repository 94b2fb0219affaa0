#include "replay/outputs/report_html.h"

namespace glide::replay {
namespace {

/// In JSON a '<' stands within strings only, where \u003c means the same.
std::string withoutTags(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace

std::string reportHtml(std::string_view page, const nlohmann::ordered_json& data) {
  const std::size_t mark = page.find(kReportDataMark);
  if (mark == std::string_view::npos) return std::string(page);
  // File names need not be UTF-8.
  const std::string json =
      data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string html(page.substr(0, mark));
  html += withoutTags(json);
  html += page.substr(mark + kReportDataMark.size());
  return html;
}

}  // namespace glide::replay
