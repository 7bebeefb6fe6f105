#include "sim/study/csv.h"

#include <fstream>
#include <sstream>

#include "hw/base/output_file.h"

namespace csgsim::study {

namespace {

void write(const std::filesystem::path& path, const std::string& text, std::ios::openmode mode) {
  std::ofstream file(path, std::ios::binary | mode);
  file << text << std::flush;
  if (!file) throw InputError(path.string() + ": cannot be written; is there room, and may you write there?");
}

/// Lines above those that are read: the title and the header.
constexpr std::size_t lines_above = 2;

}  // namespace

CsvFile::CsvFile(std::filesystem::path path, const std::string& title, const std::string& header)
    : path_(std::move(path)), begin_("# " + title + "\n" + header + "\n") {
  std::stringstream whole;
  std::ifstream file(path_, std::ios::binary);
  if (file) whole << file.rdbuf();
  const std::string text = whole.str();
  if (begin_.starts_with(text)) {
    if (text != begin_) write(path_, begin_, std::ios::trunc);
    return;
  }
  if (!text.starts_with(begin_)) {
    throw InputError(path_.string() +
                     ": holds another study; give this one a place of its own with -o, or delete that");
  }
  const std::size_t whole_lines = text.rfind('\n') + 1;
  if (whole_lines < text.size()) write(path_, text.substr(0, whole_lines), std::ios::trunc);
  std::istringstream lines(text.substr(begin_.size(), whole_lines - begin_.size()));
  for (std::string line; std::getline(lines, line);) found_.push_back(std::move(line));
}

void CsvFile::refuse(std::size_t found, std::string_view why) const {
  throw InputError(fmt::format("{}:{}:1: {}; delete the line to have it measured anew", path_.string(),
                               lines_above + found + 1, why));
}

void CsvFile::append(const std::string& line) const { write(path_, line + "\n", std::ios::app); }

void CsvFile::replace(const std::vector<std::string>& lines) const {
  std::string text = begin_;
  for (const std::string& line : lines) text += line + "\n";
  write_file(path_, text);
}

std::vector<std::string> split_cells(std::string_view line) {
  if (line.find_first_of("\n\r") != std::string_view::npos)
    throw InputError("a line break within the line, maybe of an editor that ends lines with CR LF");
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool doubled = quoted && line.substr(i).starts_with("\"\"");
    if (doubled) {
      cells.back() += line[++i];
    } else if (line[i] == '"') {
      quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += line[i];
    }
  }
  if (quoted) throw InputError("a quote is left open");
  return cells;
}

std::string to_cell(const std::string& text) {
  if (text.find_first_of("\n\r") != std::string::npos)
    throw InputError("'" + text + "': a line break does not go into a table; take another name");
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

}  // namespace csgsim::study
