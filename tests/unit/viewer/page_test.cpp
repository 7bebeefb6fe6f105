// Tests of the page's files, the form of the effects, and the members of its requests.

#include "sim/viewer/page.h"

#include "host/effects/rows.h"
#include "sim/report/parts_html.h"
#include "sim/viewer/effects_form.h"
#include "sim/viewer/files.h"
#include "sim/viewer/json_request.h"
#include "tests/support/test.h"

using namespace csgsim;
using Json = nlohmann::ordered_json;

namespace {

std::string request_error(const std::function<void()>& call) {
  try {
    call();
  } catch (const viewer::RequestError& error) {
    return error.what();
  }
  return "";
}

/// Returns the section or key with this name.
const Json& named_in(const Json& all, const std::string& name) {
  static const Json none;
  const auto found = std::ranges::find_if(all, [&](const Json& one) { return one["name"] == name; });
  return found == all.end() ? none : *found;
}

}  // namespace

TEST_CASE("an empty path returns the page and a file's type follows from its extension") {
  const std::optional<viewer::Reply> page = viewer::page_file("");
  REQUIRE(page);
  CHECK(page->status == 200);
  CHECK(page->type == "text/html; charset=utf-8");
  CHECK(page->body.find("<html") != std::string::npos);
  CHECK_FALSE(page->has_scripts);
  CHECK(viewer::page_file("page.html")->body == page->body);
  const std::optional<viewer::Reply> style = viewer::page_file("page.css");
  REQUIRE(style);
  CHECK(style->type == "text/css; charset=utf-8");
  CHECK(style->body == report::page_style);
  std::size_t scripts = 0;
  for (const viewer::PageFile& file : viewer::page_files()) {
    const std::string name(file.name);
    CAPTURE(name);
    const std::optional<viewer::Reply> reply = viewer::page_file(name);
    REQUIRE(reply);
    CHECK(reply->body == file.text);
    const bool is_script = name.ends_with(".js");
    scripts += is_script ? 1U : 0U;
    CHECK(reply->type == (is_script                ? "text/javascript; charset=utf-8"
                          : name.ends_with(".css") ? "text/css; charset=utf-8"
                                                   : "text/html; charset=utf-8"));
  }
  CHECK(scripts > 10);
  for (const char* const other : {"page", "page.htm", "page.css/", "../page.html", "draw"})
    CHECK_FALSE(viewer::page_file(other));
}

TEST_CASE("the effects form has each key of each effect except colour tables") {
  const Json form = viewer::effects_form();
  const auto sections = effects::sections();
  REQUIRE(form.size() == sections.size());
  std::size_t keys = 0;
  std::size_t tables = 0;
  for (std::size_t i = 0; i < form.size(); ++i) {
    const scene::Section& section = sections[i];
    CHECK("effects." + form[i]["name"].get<std::string>() == section.name);
    CHECK(form[i]["meaning"] == section.meaning);
    CHECK(form[i]["is_list"] == section.is_list);
    CHECK(form[i]["key"] == std::string(section.name) + (section.is_list ? ".0" : ""));
    keys += form[i]["keys"].size();
    for (const scene::KeyValue& one : section.blank()) {
      const bool is_table = one.key.kind == scene::ValueKind::colour_table;
      tables += is_table ? 1U : 0U;
      CHECK(named_in(form[i]["keys"], std::string(one.key.name)).is_null() == is_table);
    }
  }
  CHECK(keys > 30);
  CHECK(tables == 1);  // texels
  // Values as in docs/effects.md.
  const Json& cue = named_in(form, "depth_cue");
  CHECK(cue["key"] == "effects.depth_cue");
  CHECK(cue["is_list"] == false);
  const Json& bits = named_in(cue["keys"], "bits");
  CHECK(bits["allowed"] == "integer, 1 to 6");
  CHECK(bits["unit"] == "bits");
  CHECK(bits["usual"] == "5");
  CHECK(bits["meaning"] == "resolution of the fading: 2^bits steps");
  CHECK_FALSE(bits.contains("choices"));
  CHECK(named_in(named_in(form, "antialias")["keys"], "adaptive")["choices"] == Json{"true", "false"});
  CHECK(named_in(named_in(form, "transparency")["keys"], "method")["choices"].size() > 1);
  CHECK(named_in(form, "cuts")["key"] == "effects.cuts.0");
  CHECK(named_in(form, "cuts")["is_list"] == true);
}

TEST_CASE("a missing or null member of a request is empty but a wrong type is an error") {
  const Json request{{"text", "x"},  {"texts", {"a", "b"}},  {"number", 7U},    {"flag", true},
                     {"off", false}, {"object", {{"a", 1}}}, {"null", nullptr}, {"less", -7},
                     {"part", 1.5},  {"mixed", {"a", 1}}};
  CHECK(viewer::text_in(request, "text") == "x");
  CHECK(viewer::texts_in(request, "texts") == std::vector<std::string>{"a", "b"});
  CHECK(viewer::number_in(request, "number") == 7);
  CHECK(viewer::flag_in(request, "flag"));
  CHECK_FALSE(viewer::flag_in(request, "off"));
  CHECK(viewer::object_in(request, "object") == Json{{"a", 1}});
  for (const char* const key : {"none", "null"}) {
    CHECK(viewer::text_in(request, key).empty());
    CHECK(viewer::texts_in(request, key).empty());
    CHECK_FALSE(viewer::number_in(request, key));
    CHECK_FALSE(viewer::flag_in(request, key));
    CHECK(viewer::object_in(request, key) == Json::object());
  }
  const auto errors = [&](const char* key) {
    return std::vector<std::string>{request_error([&] { static_cast<void>(viewer::text_in(request, key)); }),
                                    request_error([&] { static_cast<void>(viewer::texts_in(request, key)); }),
                                    request_error([&] { static_cast<void>(viewer::number_in(request, key)); }),
                                    request_error([&] { static_cast<void>(viewer::flag_in(request, key)); }),
                                    request_error([&] { static_cast<void>(viewer::object_in(request, key)); })};
  };
  const auto all = [](const std::string& key) {
    return std::vector<std::string>{key + " must be a string", key + " must be an array of strings",
                                    key + " must be a number", key + " must be true or false",
                                    key + " must be an object"};
  };
  const std::vector<std::pair<std::string, std::size_t>> right{
      {"text", 0}, {"texts", 1}, {"number", 2}, {"flag", 3}, {"object", 4}};
  for (const auto& [key, own] : right) {
    std::vector<std::string> expected = all(key);
    expected[own].clear();
    CHECK(errors(key.c_str()) == expected);
  }
  CHECK(errors("less")[2] == "less must be a number");
  CHECK(errors("part")[2] == "part must be a number");
  CHECK(errors("mixed")[1] == "mixed must be an array of strings");
}

TEST_CASE("a message to the page is one line with invalid UTF-8 replaced") {
  CHECK(viewer::text_of(Json{{"b", {1, 2}}, {"a", "x"}}) == R"({"b":[1,2],"a":"x"})");
  CHECK(viewer::text_of(Json("a\xffz")) == "\"a\xef\xbf\xbdz\"");
}
