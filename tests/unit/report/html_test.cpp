#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "sim/report/parts_html.h"

using namespace csgsim;
using Json = nlohmann::ordered_json;

TEST_CASE("JSON in a script element cannot end it or start a comment and parses unchanged") {
  const Json json{{"</script><script>alert(1)</script>", "<!--<script>"}, {"number", 0.1}};
  const std::string text = report::json_in_html(json);
  CHECK(text.find('<') == std::string::npos);
  CHECK(Json::parse(text) == json);
}

TEST_CASE("bytes that are not UTF-8 become valid JSON in a page") {
  const Json json = Json::parse(report::json_in_html(Json{"\xff\xfe"}));
  CHECK(json.front() == "\xef\xbf\xbd\xef\xbf\xbd");
}

TEST_CASE("a section's id is its title in lower case with hyphens") {
  CHECK(report::html_id("Where the clocks go") == "where-the-clocks-go");
  CHECK(report::html_id(" <b onclick=x> ") == "b-onclick-x");
}
