#include "replay/outputs/report_html.h"

#include "replay/outputs/report_template.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::replay {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::ordered_json;

constexpr std::string_view kPage = "<script id=\"run\">{{RUN}}</script><p>{{RUN}} stays</p>";

/// What stands in the script element.
std::string dataOf(const std::string& html) {
  const std::string begin = "<script id=\"run\">";
  const std::size_t from = html.find(begin) + begin.size();
  return html.substr(from, html.find("</script>", from) - from);
}

TEST(ReportHtml, PutsTheDataInItsPlace) {
  EXPECT_EQ(reportHtml(kPage, Json{{"a", 1}}),
            "<script id=\"run\">{\"a\":1}</script><p>{{RUN}} stays</p>");
}

TEST(ReportHtml, LetsNoNameEndTheScript) {
  const std::string name = "</script><script>alert(1)</script><!-- & \" {{RUN}}";
  const std::string data = dataOf(reportHtml(kPage, Json{{"name", name}}));
  EXPECT_THAT(data, Not(HasSubstr("<")));
  EXPECT_EQ(Json::parse(data)["name"], name);
}

TEST(ReportHtml, TakesNamesThatAreNoUtf8) {
  const std::string data = dataOf(reportHtml(kPage, Json{{"name", "caf\xE9"}}));
  EXPECT_EQ(Json::parse(data)["name"], "caf\xEF\xBF\xBD");
}

TEST(ReportTemplate, HasAPlaceForTheDataAndAsksForNothingFromOutside) {
  if (reportTemplate().empty()) GTEST_SKIP() << "built without npm: there is no page";
  const std::string page(reportTemplate());
  EXPECT_THAT(page, HasSubstr("<script id=\"run\" type=\"application/json\">{{RUN}}</script>"));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, Not(HasSubstr("{{SCRIPT}}")));
  EXPECT_THAT(page, Not(HasSubstr("<script src")));
}

}  // namespace
}  // namespace glide::replay
