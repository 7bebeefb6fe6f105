#include <cctype>

#include "places.h"
#include "tests/cli/cli.h"
#include "tests/cli/help_lines.h"

using namespace csgsim::testing::cli;

namespace {

/// A command's options by their last name, with the help text of each on one line.
std::map<std::string, std::string> options_of(const std::string& command) {
  std::map<std::string, std::string> options;
  std::string* text = nullptr;
  for (const std::string& line : lines_of(run(command + " --help").out)) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == 2 && line[2] == '-') {
      const std::size_t name = line.find("--");
      text = &options[line.substr(name, line.find_first_of(" ,", name) - name)];
    } else if (begin != 26) {
      text = nullptr;
    }
    if (text != nullptr) *text += "  " + line.substr(begin);
  }
  return options;
}

/// The longest of the words that help lists for an option; empty if any text is allowed.
std::string longest_word(const std::string& text) {
  const std::size_t begin = text.find("Values: ");
  if (begin == std::string::npos) return {};
  const std::size_t first = begin + std::string("Values: ").size();
  std::string list = text.substr(first, text.find('[', first) - first);
  std::ranges::replace(list, ',', '\n');
  std::string longest;
  for (const std::string& word : lines_of(list)) {
    const std::size_t plain_begin = word.find_first_not_of(' ');
    const std::string plain = word.substr(plain_begin, word.find_last_not_of(' ') + 1 - plain_begin);
    if (plain.size() > longest.size()) longest = plain;
  }
  return longest;
}

}  // namespace

TEST_CASE("no line of any help exceeds 80 columns") {
  REQUIRE(commands().size() >= 18);
  std::vector<std::string> helps{run("--help").out};
  for (const std::string& command : commands()) helps.push_back(run(command + " --help").out);
  for (const std::string& help : helps) {
    for (const std::string& line : lines_of(help)) {
      CAPTURE(line);
      CHECK(line.size() <= 80);
      CHECK((line.empty() || line.back() != ' '));
    }
  }
}

TEST_CASE("lines of remarks in help break only if the next word does not fit") {
  for (const std::string& command : commands()) {
    const std::vector<std::string> lines = lines_of(run(command + " --help").out);
    const auto example = std::ranges::find(lines, "Example:");
    CAPTURE(command);
    REQUIRE(example != lines.end());
    for (auto line = example + 1; line + 1 < lines.end(); ++line) {
      const std::string& next = *(line + 1);
      if (line->starts_with("  ") || next.starts_with("  ")) continue;
      CAPTURE(*line);
      CHECK(line->size() + 1 + std::min(next.find(' '), next.size()) > 80);
    }
  }
}

TEST_CASE("help lists every option under a subject") {
  const std::string help = run("render --help").out;
  std::size_t at = 0;
  for (const std::string subject : {"Model and scene:", "View:", "Machine:", "Algorithm and pixel memory:", "Accuracy:",
                                    "The run:", "Outputs:", "Messages:", "Example:"}) {
    CAPTURE(subject);
    const std::size_t found = help.find("\n\n" + subject + "\n");
    CHECK(found != std::string::npos);
    CHECK(found >= at);
    at = found;
  }
  for (const std::string& command : commands()) {
    CAPTURE(command);
    INFO("each option's subject is in sim/session/options/option_table.cpp");
    CHECK(run(command + " --help").out.find("Further options:") == std::string::npos);
  }
}

TEST_CASE("examples in help continue after a backslash as in a shell") {
  const std::string help = run("render --help").out;
  CHECK(help.find("--camera 220,-255,135,2,0,5 \\\n      --stats carburettor.json\n") != std::string::npos);
}

TEST_CASE("a wrong word of any option is reported with the nearest and all valid words") {
  std::map<std::string, std::string> tested;
  for (const std::string& command : commands()) {
    for (const auto& [name, text] : options_of(command)) {
      const std::string& option = name;  // clang cannot capture a structured binding
      const std::string word = longest_word(text);
      if (word.empty()) continue;
      tested[option] = command;
      std::string wrong = word;
      std::swap(wrong[1], wrong[2]);
      CAPTURE(command);
      CAPTURE(option);
      const std::string operand = command == "rtl" ? "pixel-planes-4" : "m.csg";
      fails(run_words({command, operand, option, wrong}), 2,
            {"there is no ", "'" + wrong + "'; did you mean " + word + "? The "});
    }
  }
  for (const std::string option : {"--strategy", "--colouring", "--level", "--levels", "--projection", "--progress",
                                   "--pruning", "--pruning-a", "--colour-scheme", "--strategy-b"}) {
    CAPTURE(option);
    CHECK(tested.count(option) == 1);
  }
}

TEST_CASE("errors for unknown machines and effects and settings and fields have one form") {
  const Outcome machine = run("render " + model("old_example003") + " --machine scanline");
  fails(machine, 2, {"there is no machine 'scanline'; did you mean scan-line? The machines are pixel-planes-4, "});
  check_misuse("manual machines foo", "there is no machine 'foo'; the machines are pixel-planes-4, ");
  check_misuse("render " + model("old_example003") + " --set effects.shadow.on=true",
               "there is no effect 'shadow'; did you mean shadows? The effects are ");
  check_misuse("render " + model("old_example003") + " --set effects.transparency.method=screendor",
               "did you mean screen-door? it must be one of layers, screen-door");
  const Outcome field = run("wave " + std::string(CSGSIM_SOURCE_DIR) +
                            "/traces/thesis_fig_2_3.csgt --pixel 1,1 --at Z3 -o " + (Folder() / "w.vcd"));
  CHECK(field.code == 2);
}

TEST_CASE("--quiet prints nothing except errors and warnings") {
  const Folder folder;
  const std::string draw = model("old_example011") + " --size 16x16 ";
  for (const std::string& words :
       {"render " + draw + "-o " + (folder / "p.png"), "compile " + draw + "-o " + (folder / "p.csgt"),
        "run " + (folder / "p.csgt") + " --stats " + (folder / "s.json"), "levels " + draw,
        "effects " + draw + "-o " + (folder / "e"),
        "sweep " + draw + "--strategy stack -o " + (folder / "s") + " --no-plots",
        "accuracy " + draw + "--views 1 -o " + (folder / "a") + " --no-plots",
        "compare " + draw + "--machines pixel-planes-4 --sides 8 --fragments 4 -o " + (folder / "c") + " --no-plots",
        "wave " + draw + "--pixel 1,1 --window 0:9 -o " + (folder / "w.vcd")}) {
    CAPTURE(words);
    CHECK(run(words).out != "");
    const Outcome quiet = run(words + " -q");
    CHECK(quiet.out == "");
    CHECK(quiet.err == "");
    CHECK(quiet.code == 0);
  }
  const Outcome differing = run("diff " + draw + model("old_example003") + " -q");
  CHECK(differing.out == "");
  CHECK(differing.err == "A and B differ\n");
  CHECK(run("render none.csg --quiet").err.find("none.csg") != std::string::npos);
  CHECK(run("render " + draw + "--projection perspective --near 0.001 --z-bits 8 -q").err.starts_with("warning: "));
}
