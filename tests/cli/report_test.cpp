#include <cctype>

#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;
using Json = nlohmann::json;

namespace {

/// The text between two texts, searched from `at`, which moves behind it; empty if not found.
std::string between(const std::string& text, const std::string& begin, const std::string& end, std::size_t& at) {
  const std::size_t from = text.find(begin, at);
  if (from == std::string::npos) return "";
  const std::size_t to = text.find(end, from + begin.size());
  at = to;
  return text.substr(from + begin.size(), to - from - begin.size());
}

Json data_of(const std::string& html) {
  std::size_t at = 0;
  return Json::parse(between(html, "<script type=\"application/json\" id=\"data\">", "</script>", at));
}

Json without_wall_times(Json values) {
  if (values.is_object()) {
    for (auto one = values.begin(); one != values.end();)
      one = one.key().starts_with("wall_seconds") ? values.erase(one) : std::next(one);
  }
  for (Json& one : values)
    if (one.is_structured()) one = without_wall_times(one);
  return values;
}

std::string digits(const std::string& text) {
  std::string kept;
  for (const char c : text)
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-') kept.push_back(c);
  return kept;
}

/// Compares each table cell of the page that names its source value with a file; returns the number of whole numbers.
std::size_t hold_cells(const std::string& html, const Json& file) {
  std::size_t whole = 0;
  for (std::size_t at = 0;;) {
    const std::string pointer = between(html, " data-at=\"", "\"", at);
    if (pointer.empty()) return whole;
    const std::string text = between(html, ">", "<", at);
    CAPTURE(pointer);
    REQUIRE(file.contains(Json::json_pointer(pointer)));
    const Json& value = file.at(Json::json_pointer(pointer));
    if (!value.is_number_integer()) continue;
    ++whole;
    CHECK(digits(text) == value.dump());
  }
}

/// Checks that the page loads nothing from elsewhere.
void loads_nothing(const std::string& html) {
  for (const std::string part : {"http://", "https://", "src=\"/", "src=//", "url(", "@import", "<link rel=stylesheet"})
    CHECK(html.find(part) == std::string::npos);
}

}  // namespace

TEST_CASE("the report of a render shows the numbers of its stats and is reproducible") {
  const Folder folder;
  const std::string command = "render " + model("old_example011") + " --size 64x48 --view-all --stats " +
                              (folder / "s.json") + " --report " + (folder / "r.html");
  require_success(run(command));
  const std::string html = content(folder / "r.html");
  const Json stats = json(folder / "s.json");
  CHECK(data_of(html) == without_wall_times(stats));
  CHECK(hold_cells(html, stats) > 40);
  loads_nothing(html);
  CHECK(html.find("csgsim render ") != std::string::npos);
  CHECK(html.find("--size 64x48") != std::string::npos);
  CHECK(html.find("id=\"drawing-0\"") != std::string::npos);
  CHECK(html.find("id=\"owners-data\"") != std::string::npos);
  require_success(run(command));
  CHECK(content(folder / "r.html") == html);
}

TEST_CASE("the report of an ordinary render is smaller than 2 MB") {
  const Folder folder;
  require_success(run("render " + model("terrain_vehicle") +
                      " --camera 560,-590,420,-5,0,68 --projection perspective --report " + (folder / "r.html")));
  CHECK(fs::file_size(folder / "r.html") < 2'000'000);
}

TEST_CASE("the report of each study has the numbers of its JSON file") {
  const Folder folder;
  const std::string of = " " + model("old_example011") + " --size 32x32 ";
  const std::vector<std::pair<std::string, std::string>> studies{
      {"accuracy" + of + "--views 1 --no-plots", "accuracy.json"},
      {"sweep" + of + "--strategy stack,bits --stack-bits 3,4 --pruning all,none --no-plots", "sweep.json"},
      {"compare" + of + "--machines pixel-planes-4,scan-line --sides 16 --fragments 3 --no-plots", "compare.json"},
      {"compare" + of + "--machines pixel-planes-4 --ideal", "compare.json"},
      {"corpus" + of + model("thesis_fig_2_3") + " --machines pixel-planes-4,scan-line --no-plots", "corpus.json"},
      {"effects" + of + "--scene " + std::string(CSGSIM_SOURCE_DIR) + "/tests/scenes/depth_cue.toml --memory-bits 128",
       "effects.json"}};
  for (std::size_t i = 0; i < studies.size(); ++i) {
    const std::string command = studies[i].first;
    const std::string file = studies[i].second;
    CAPTURE(command);
    const std::string out = folder / std::to_string(i);
    const std::string page = out + ".html";
    require_success(run(command + " -o " + out + " --report " + page));
    const std::string html = content(page);
    const auto expected = json(out + "/" + file);
    CHECK(data_of(html) == without_wall_times(expected));
    CHECK(hold_cells(html, expected) > 8);
    CHECK((html.find("src=\"data:image/png;base64,") != std::string::npos) == !command.starts_with("corpus"));
    CHECK(html.find("<th scope=row>clock.frequency</th>") != std::string::npos);
    loads_nothing(html);
  }
}

TEST_CASE("the report of advise has the front and the recommended commands") {
  const Folder folder;
  const std::string of =
      "advise " + model("old_example011") + " --size 32x32 --z-bits 12,14 --fraction-bits 2,6 --no-plots ";
  for (const std::string wishes : {"--min-colour-bits 15", "--max-bits 20 --max-wrong-pixels 0"}) {
    const Outcome outcome = run(of + wishes + " -o " + (folder / "a") + " --report " + (folder / "a.html"));
    const std::string html = content(folder / "a.html");
    const auto expected = json(folder / "a/advise.json");
    CHECK(outcome.code == (expected["meets_all"] == true ? 0 : 1));
    CHECK(expected.contains("nearest") == (outcome.code == 1));
    Json kept = without_wall_times(expected);
    kept.erase("points");
    CHECK(data_of(html) == kept);
    CHECK(hold_cells(html, expected) > 10 * expected["front"].size());
    const std::size_t recommended = expected["recommendations"].size();
    for (std::size_t i = 0; i < recommended; ++i)
      CHECK(html.find("/recommendations/" + std::to_string(i) + "/point/z_bits") != std::string::npos);
    for (const Json& one : expected["recommendations"]) {
      const std::string command = one["command"];
      CHECK(command.find("--report") == std::string::npos);
      CHECK(html.find(command.substr(0, command.find('\''))) != std::string::npos);
    }
    CHECK(html.find("src=\"data:image/png;base64,") != std::string::npos);
    CHECK(html.find(std::to_string(expected["points"].size()) + " choices were searched") != std::string::npos);
    loads_nothing(html);
  }
}

TEST_CASE("writing a report changes neither a study's title nor its stored points") {
  const Folder folder;
  const std::string command =
      "sweep " + model("old_example011") + " --size 16x16 --strategy stack --no-plots -o " + (folder / "s");
  require_success(run(command));
  const std::string table = content(folder / "s/sweep.csv");
  require_success(run(command + " --report " + (folder / "r.html")));
  CHECK(content(folder / "s/sweep.csv") == table);
}

TEST_CASE("rejects a report that is an input or another output or not .html") {
  const Folder folder;
  fs::copy_file(model("old_example011"), folder / "m.csg");
  fs::create_symlink("m.csg", folder / "m.html");
  const std::string of = (folder / "m.csg") + " --size 16x16 --report ";
  for (const std::string& command : {std::string("render "), "effects -o " + (folder / "e") + " "})
    CHECK(run(command + of + (folder / "m.html")).code == 2);
  CHECK(run("render " + of + (folder / "a.html") + " --stats " + (folder / "a.html")).code == 2);
  check_misuse("render " + of + (folder / "a.txt"), "must end in .html");
  check_misuse("render " + of + (folder / "a.html") + " --frames 2", "--report: is for one frame");
  check_misuse("levels " + of + (folder / "a.html"), "no option --report");
  check_misuse("render " + (folder / "m.csg") + " --raport a.html", "did you mean --report?");
  CHECK(run("render " + of + (folder / "a.html") + " --memory-bits 8").code == 1);
  CHECK_FALSE(fs::exists(folder / "a.html"));
}

TEST_CASE("the report of a model with a hostile name contains no injected markup") {
  const Folder folder;
  const std::string name = "</script><img src=x onerror=alert(1)>'\"&.csg";
  // A folder's name cannot contain the slash of a closing tag.
  fs::create_directory(folder / "<");
  fs::copy_file(model("old_example011"), folder / name);
  require_success(run_words({"render", name, "--size", "16x16", "--report", "r.html"}, folder.path()));
  const std::string html = content(folder / "r.html");
  CHECK(html.find("<img src=x") == std::string::npos);
  CHECK(html.find("&lt;/script&gt;&lt;img src=x") != std::string::npos);
  CHECK(data_of(html)["model"]["file"] == name);
}
