#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace glide::replay {

/// Where the page has its data.
inline constexpr std::string_view kReportDataMark = "{{RUN}}";

/// The page with the data in the place of kReportDataMark. Whatever names the data holds, they
/// cannot end the script element that it stands in.
std::string reportHtml(std::string_view page, const nlohmann::ordered_json& data);

}  // namespace glide::replay
