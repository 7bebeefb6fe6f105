#include "sim/suite/suite.h"

#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// A list of one case, with a line in place of another.
std::string list_with(const std::string& line, const std::string& replacement) {
  std::string text = R"(version = 3
stored = ["pixel-planes-4"]
compiled = ["scan-line"]
[settings]
projection = "ortho"
memory-bits = 72
strategy = "stack"
stack-bits = 3
colouring = "rebroadcast"
colour-bits = 24
colour-scheme = "Cornfield"
curves = "facets"
pruning = "none"
z-bits = 20
fraction-bits = 12
edge-on = 0.25
[[case]]
name = "one"
group = "hard"
about = "a cube"
model = "models/one.csg"
size = "32x32"
camera = "1,2,3,0,0,0"
memory-bits = 96
)";
  const std::size_t place = line.empty() ? std::string::npos : text.find(line);
  if (place != std::string::npos) text.replace(place, line.size(), replacement);
  return text;
}

struct Wrong {
  std::string line;
  std::string replacement;
  std::string error;  ///< a part of the message
};

}  // namespace

TEST_CASE("a list of cases is read, and a case replaces common settings") {
  const suite::Suite suite = suite::read_suite(list_with("", ""), "s.toml");
  CHECK(suite.version == "3");
  CHECK(suite.stored == std::vector<std::string>{"pixel-planes-4"});
  CHECK(suite.compiled == std::vector<std::string>{"scan-line"});
  REQUIRE(suite.cases.size() == 1);
  const suite::Case& one = suite.cases.front();
  CHECK(one.name == "one");
  CHECK(one.group == "hard");
  CHECK(one.about == "a cube");
  CHECK(one.model == "models/one.csg");
  const std::vector<std::pair<std::string, std::string>> settings{{"size", "32x32"},
                                                                  {"camera", "1,2,3,0,0,0"},
                                                                  {"projection", "ortho"},
                                                                  {"memory-bits", "96"},
                                                                  {"strategy", "stack"},
                                                                  {"stack-bits", "3"},
                                                                  {"colouring", "rebroadcast"},
                                                                  {"colour-bits", "24"},
                                                                  {"colour-scheme", "Cornfield"},
                                                                  {"curves", "facets"},
                                                                  {"pruning", "none"},
                                                                  {"z-bits", "20"},
                                                                  {"fraction-bits", "12"},
                                                                  {"edge-on", "0.25"}};
  CHECK(one.settings == settings);
  CHECK(&suite::case_named(suite, "one") == &one);
  CHECK(testing::error_of([&] { suite::case_named(suite, "ones"); }).find("did you mean one?") != std::string::npos);
}

TEST_CASE("a wrong list of cases is rejected with its place") {
  for (const Wrong& wrong : std::vector<Wrong>{
           {"version = 3\n", "", "s.toml:1:1: 'version' is missing"},
           {"version = 3", "version = []", "s.toml:1:11: 'version' is an array"},
           {"version = 3", "version = \"\"", "s.toml:1:11: 'version' is an empty string"},
           {"version = 3", "version 3", "s.toml:1:9: this is not valid TOML"},
           {"version = 3", "versions = 3", "s.toml:1:1: there is no key 'versions'; did you mean version?"},
           {"stored = [\"pixel-planes-4\"]", "stored = 4", "s.toml:2:10: 'stored' is an integer"},
           {"[settings]", "[[settings]]", "'settings' is an array"},
           {"z-bits = 20", "z-bit = 20", "s.toml:14:1: there is no key 'z-bit'; did you mean z-bits?"},
           {"z-bits = 20\n", "", "s.toml:16:1: 'z-bits' is missing; set it here or in [settings]"},
           {"[[case]]", "[case]", "'case' must be a list of tables"},
           {"name = \"one\"", "name = \"../one\"", "s.toml:18:8: the name '../one' must consist of letters"},
           {"name = \"one\"\n", "", "s.toml:17:1: 'name' is missing"},
           {"camera = ", "cameras = ", "s.toml:23:1: there is no key 'cameras'"},
           {"size = \"32x32\"", "size = true", "s.toml:22:8: 'size' is a boolean"}}) {
    CAPTURE(wrong.replacement);
    const std::string error =
        testing::error_of([&] { suite::read_suite(list_with(wrong.line, wrong.replacement), "s.toml"); });
    CAPTURE(error);
    CHECK(error.find(wrong.error) != std::string::npos);
  }
  const std::string twice = list_with("", "") + list_with("", "").substr(list_with("", "").find("[[case]]"));
  CHECK(testing::error_of([&] { suite::read_suite(twice, "s.toml"); }).find("there are two cases 'one'") !=
        std::string::npos);
}
