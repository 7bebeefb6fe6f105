// Wrong command lines and files, with the answer of csgsim to each (mistakes.txt).

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

/// A command line and the expected answer.
struct Mistake {
  int line = 0;  ///< in mistakes.txt
  std::string section;
  std::string command;
  int code = 0;
  std::string answer;  ///< `...` stands for any text
};

/// The table of mistakes: input files, and command lines in sections.
struct Table {
  std::vector<std::pair<std::string, std::string>> files;  ///< names and contents
  std::vector<std::string> folders;
  std::vector<Mistake> mistakes;
};

std::string rest_after(const std::string& line, const std::string& word) { return line.substr(word.size()); }

/// Reads the lines of a file up to the line `end`.
std::string read_content(std::istream& lines, int& number) {
  std::string content;
  for (std::string line; ++number, std::getline(lines, line) && line != "end";) content += line + "\n";
  return content;
}

Table read_table() {
  std::ifstream lines(std::string(CSGSIM_SOURCE_DIR) + "/tests/cli/mistakes.txt");
  Table table;
  std::string section;
  int number = 0;
  for (std::string line; ++number, std::getline(lines, line);) {
    if (line.starts_with("# ")) section = rest_after(line, "# ");
    if (line.starts_with("file ")) {
      const std::string name = rest_after(line, "file ");
      table.files.emplace_back(name, read_content(lines, number));
    }
    if (line.starts_with("folder ")) table.folders.push_back(rest_after(line, "folder "));
    if (line.starts_with("$ ")) table.mistakes.push_back({number, section, rest_after(line, "$ "), -1, ""});
    const bool has_code = !line.empty() && line[0] >= '0' && line[0] <= '3';
    const bool is_answer = has_code && (line.size() == 1 || line[1] == ' ');
    if (!is_answer) continue;
    REQUIRE(!table.mistakes.empty());
    table.mistakes.back().code = line[0] - '0';
    table.mistakes.back().answer = line.size() == 1 ? "" : line.substr(2);
  }
  return table;
}

/// Whether the text consists of the parts between the `...` of the pattern, with any texts between them.
bool matches(const std::string& text, const std::string& pattern) {
  const std::size_t dots = pattern.find("...");
  if (dots == std::string::npos) return text == pattern;
  if (!text.starts_with(pattern.substr(0, dots))) return false;
  const std::string rest = pattern.substr(dots + 3);
  for (std::size_t at = dots; at <= text.size(); ++at)
    if (matches(text.substr(at), rest)) return true;
  return false;
}

std::set<std::string> names_in(const Folder& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path())) names.insert(entry.path().native());
  return names;
}

/// Writes the files of the table, a Program good.csgt and its stats file stats.json.
void fill(const Folder& folder, const Table& table) {
  for (const std::string& name : table.folders) fs::create_directory(folder / name);
  for (const auto& [name, text] : table.files) write(folder / name, text);
  require_success(run_words({"compile", "cube.csg", "--size", "16x16", "-o", "good.csgt", "-q"}, folder.path()));
  require_success(run_words({"render", "cube.csg", "--size", "16x16", "--stats", "stats.json", "-q"}, folder.path()));
}

/// Runs the command as a shell would; csgsim is found through PATH.
Outcome run_in_shell(const std::string& command, const Folder& folder) {
  const std::string path = std::string(CSGSIM_BINARY_DIR) + ":/usr/bin:/bin";
  return run_program("env", {"PATH=" + path, "sh", "-c", command}, folder.path());
}

/// Runs every command of a section and compares its answer. No command may write a file.
void check_section(const std::string& section) {
  const Table table = read_table();
  const Folder folder;
  fill(folder, table);
  const std::set<std::string> before = names_in(folder);
  int count = 0;
  for (const Mistake& mistake : table.mistakes) {
    if (mistake.section != section) continue;
    ++count;
    CAPTURE(mistake.line);
    CAPTURE(mistake.command);
    const Outcome outcome = run_in_shell(mistake.command, folder);
    CAPTURE(outcome.err);
    CHECK(outcome.code == mistake.code);
    const std::string& text = mistake.code == 0 ? outcome.out : outcome.err;
    if (mistake.code != 0) CHECK(is_one_line(text));
    CHECK(matches(text.substr(0, text.find('\n')), mistake.answer));
    CHECK(names_in(folder) == before);
  }
  CHECK(count > 0);
}

}  // namespace

TEST_CASE("mistakes in the name of the command are answered with a command line that works") {
  check_section("Commands");
}

TEST_CASE("every command without arguments says what it needs") { check_section("Commands without arguments"); }

TEST_CASE("missing and unexpected arguments are named, with what to write") { check_section("Arguments"); }

TEST_CASE("unknown options are answered with the option that was probably meant") { check_section("Options"); }

TEST_CASE("wrong numbers and words are named, with what is possible") { check_section("Values"); }

TEST_CASE("wrong machines and parameters are named, with what is possible") { check_section("Machines"); }

TEST_CASE("quantities of parameters have units, and wrong units are rejected") { check_section("Quantities"); }

TEST_CASE("wrong scene keys of --set are answered with the key that was probably meant") {
  check_section("Scene keys");
}

TEST_CASE("missing and unsuitable input files are named, with what is possible") { check_section("Files"); }

TEST_CASE("outputs that cannot be written are named, with what to do") { check_section("Outputs"); }

TEST_CASE("mistakes in settings, scenes, machines and cameras are reported with their place") {
  check_section("Settings");
}

TEST_CASE("wrong pixels, windows and fields are named, with what is possible") { check_section("Queries"); }

TEST_CASE("wrong lists, shards and dimensions of studies are named, with what is possible") {
  check_section("Studies");
}

TEST_CASE("the debugger accepts gdb's commands and reports the place of wrong commands") { check_section("Debugger"); }

TEST_CASE("the table of mistakes covers every command, and every section is tested") {
  const Table table = read_table();
  std::set<std::string> sections;
  for (const Mistake& mistake : table.mistakes) {
    CAPTURE(mistake.line);
    CHECK(mistake.code >= 0);
    sections.insert(mistake.section);
  }
  CHECK(sections.size() == 14);
  CHECK(table.mistakes.size() >= 150);
  std::istringstream overview(run("--help").out);
  int commands = 0;
  for (std::string line; std::getline(overview, line);) {
    const bool is_command = line.starts_with("  ") && line.size() > 2 && line[2] >= 'a' && line[2] <= 'z';
    if (!is_command) continue;
    const std::string name = line.substr(2, line.find(' ', 2) - 2);
    CAPTURE(name);
    // bench-suite without arguments runs everything.
    const std::string command = "csgsim " + name;
    CHECK(std::ranges::any_of(table.mistakes, [&](const Mistake& one) {
      return one.command == command || (name == "bench-suite" && one.command.starts_with(command + " "));
    }));
    ++commands;
  }
  CHECK(commands > 20);
}
