#include "tests/faults/bench.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

#include "places.h"

namespace csgsim::testing::faults {

namespace {

namespace fs = std::filesystem;

std::string with(std::string text, const std::string& word, const std::string& replacement) {
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += replacement.size())
    text.replace(at, word.size(), replacement);
  return text;
}

std::vector<std::string> split(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// The complete lines of a text; the rest after the last line break is dropped.
std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text.substr(0, text.rfind('\n') + 1));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

void erase(std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t first = text.find(begin);
  if (first == std::string::npos) return;
  text.erase(first, text.find(end, first + begin.size()) - first);
}

/// A file's content without the parts that vary between runs: times and options (stats) or the date (waves).
std::string without_varying_parts(const std::string& path) {
  std::string text = cli::content(path);
  if (path.ends_with(".json")) {
    erase(text, "\"configuration\"", "\"wall_seconds\"");
    erase(text, "\"wall_seconds\"", "\n");
  }
  if (path.ends_with(".vcd")) erase(text, "$date", "$end");
  return text;
}

std::string old(const std::string& name) { return "what was in " + name + " before\n"; }

/// The first nonempty text.
std::string first_of(std::initializer_list<std::string> all) {
  for (const std::string& one : all) {
    if (!one.empty()) return one;
  }
  return {};
}

}  // namespace

Bench::Bench(Command command) : command_(std::move(command)) {
  fs::create_directories(folder_ / "tmp");
  const std::size_t lines_before = std::exchange(command_.lines_before, 0);
  reset();
  const ChildResult ended = run();
  CAPTURE(ended.err);
  REQUIRE(ended.code == 0);
  for (const std::string& name : command_.outputs) wanted_[name] = without_varying_parts(out(name));
  if (!command_.table.empty()) {
    for (const std::string& name : {command_.table, title()}) wanted_[name] = without_varying_parts(out(name));
  }
  command_.lines_before = lines_before;
  REQUIRE(success_mismatch(ended).empty());
}

void Bench::reset() const {
  fs::remove_all(folder_ / "out");
  fs::remove(report());
  if (command_.table.empty() || command_.lines_before > 0) fs::create_directory(folder_ / "out");
  if (!fs::exists(folder_ / "out")) return;
  for (const std::string& name : command_.outputs) cli::write(out(name), old(name));
  if (command_.lines_before == 0) return;
  cli::write(out(command_.table), table_before());
  cli::write(out(title()), wanted_.at(title()));
}

std::string Bench::title() const { return fs::path(command_.table).replace_extension(".study"); }

std::string Bench::table_before() const {
  const std::string& whole = wanted_.at(command_.table);
  std::size_t end = 0;
  for (std::size_t line = 0; line < command_.lines_before; ++line) end = whole.find('\n', end) + 1;
  return whole.substr(0, end + (whole.find('\n', end) - end) / 2);
}

ChildResult Bench::run(const Conditions& conditions) const {
  Conditions all = conditions;
  all.environment["TMPDIR"] = folder_ / "tmp";
  return run_csgsim(split(with(with(command_.words, "OUT", folder_ / "out"), "SOURCE", CSGSIM_SOURCE_DIR)), all);
}

std::string Bench::message_mismatch(const ChildResult& result) const {
  if (result.signal != 0) return "ended by signal " + std::to_string(result.signal);
  if (result.code != 1) return "exit code " + std::to_string(result.code) + ", " + result.err;
  if (!cli::is_one_line(result.err)) return "the error is not one line: " + result.err;
  std::vector<std::string> named{folder_ / "out", folder_ / "tmp"};
  for (const auto& [name, content] : wanted_) named.push_back(out(name));
  if (wanted_.empty()) named.emplace_back("/dev/stdout");
  const bool names_one =
      result.err.starts_with(folder_ / "tmp/.csgsim-") ||
      std::ranges::any_of(named, [&](const std::string& name) { return result.err.starts_with(name + ": "); });
  return names_one ? "" : "names no file: " + result.err;
}

std::string Bench::outputs_mismatch() const {
  for (const std::string& name : command_.outputs) {
    const bool was_there = command_.table.empty() || command_.lines_before > 0;
    if (!fs::exists(out(name))) {
      if (was_there) return name + " no longer exists";
      continue;
    }
    const std::string content = without_varying_parts(out(name));
    if (content != old(name) && content != wanted_.at(name)) return name + " is neither the old file nor the new one";
  }
  return {};
}

std::string Bench::table_mismatch() const {
  if (command_.table.empty()) return {};
  if (fs::exists(out(title())) && cli::content(out(title())) != wanted_.at(title()))
    return "the title file next to the table has other content";
  const std::string text = cli::content(out(command_.table));
  const bool is_there = fs::exists(out(command_.table));
  if (command_.lines_before > 0 ? is_there && text == table_before() : !is_there) return {};
  const std::vector<std::string> lines = lines_of(text);
  const std::vector<std::string> wanted = lines_of(wanted_.at(command_.table));
  if (lines.size() < std::max<std::size_t>(1, command_.lines_before)) return "the table has lost lines";
  if (text.back() != '\n') return "the table ends in part of a line";
  if (lines.front() != wanted.front()) return "the table has another header";
  const std::set<std::string> known(wanted.begin(), wanted.end());
  const std::set<std::string> found(lines.begin(), lines.end());
  if (found.size() != lines.size()) return "the table has a line twice";
  return std::ranges::includes(known, found) ? "" : "the table has a line that is no row";
}

std::string Bench::left_behind() const {
  for (const char* const folder : {"out", "tmp"}) {
    if (!fs::exists(folder_ / folder)) continue;
    for (const auto& entry : fs::directory_iterator(folder_ / folder)) {
      const std::string name = entry.path().filename().native();
      if (std::string(folder) == "tmp" || !wanted_.contains(name)) return "unexpected file: " + entry.path().native();
    }
  }
  return {};
}

std::string Bench::files_mismatch() const { return first_of({left_behind(), outputs_mismatch(), table_mismatch()}); }

std::string Bench::failure_mismatch(const ChildResult& result) const {
  return first_of({message_mismatch(result), files_mismatch()});
}

std::string Bench::failure_mismatch_except_table(const ChildResult& result) const {
  return first_of({message_mismatch(result), left_behind(), outputs_mismatch()});
}

std::string Bench::success_mismatch(const ChildResult& result) const {
  if (result.code != 0 || !result.err.empty()) return "failed: " + result.err;
  for (const auto& [name, content] : wanted_) {
    if (!fs::exists(out(name))) return name + " is missing";
    if (without_varying_parts(out(name)) != content)
      return name + " differs from its content after a run without faults";
  }
  return left_behind();
}

std::size_t Bench::replaced() const {
  const auto is_new = [&](const std::string& name) {
    return fs::exists(out(name)) && cli::content(out(name)) != old(name);
  };
  return static_cast<std::size_t>(std::ranges::count_if(command_.outputs, is_new));
}

std::vector<std::uint64_t> Bench::sizes() const {
  std::vector<std::uint64_t> all;
  for (const auto& [name, content] : wanted_) all.push_back(content.size());
  return all;
}

}  // namespace csgsim::testing::faults
