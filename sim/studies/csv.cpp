#include "sim/studies/csv.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "hw/base/descriptor.h"
#include "hw/base/input_file.h"
#include "hw/base/output_file.h"

namespace csgsim::studies {

namespace {

constexpr InputKind table_file{"a .csv file", std::size_t{256} << 20U, "choose another folder for the study with -o",
                               true};
constexpr InputKind title_file{"a .study file", std::size_t{4} << 20U, "choose another folder for the study with -o",
                               true};

/// The content of the file; empty if it does not exist.
std::string text_of(const std::filesystem::path& path, const InputKind& kind) {
  std::error_code error;
  return std::filesystem::exists(path, error) ? read_regular_file(path, kind) : std::string();
}

[[noreturn]] void refuse_other(const std::filesystem::path& path) {
  throw InputError(path.native() + ": holds another study; choose another folder with -o, or delete the file");
}

}  // namespace

CsvFile::CsvFile(std::filesystem::path path, std::string header) : path_(std::move(path)), begin_(std::move(header)) {
  const std::string text = text_of(path_, table_file);
  if (begin_.starts_with(text)) {
    if (text != begin_) write_file(path_, begin_);
    return;
  }
  if (!text.starts_with(begin_)) refuse_other(path_);
  const std::size_t whole_lines = text.rfind('\n') + 1;
  if (whole_lines < text.size()) write_file(path_, std::string_view(text).substr(0, whole_lines));
  std::istringstream lines(text.substr(begin_.size(), whole_lines - begin_.size()));
  for (std::string line; std::getline(lines, line);) found_.push_back(std::move(line));
}

CsvFile open_study_table(const std::filesystem::path& path, const std::string& title, const std::string& header_line) {
  const std::string begin = header_line + "\n";
  const std::string comment = "# " + title + "\n";
  const std::filesystem::path beside = std::filesystem::path(path).replace_extension(".study");
  const std::string text = text_of(path, table_file);
  const bool is_commented = text.starts_with('#');
  const bool is_new = (is_commented ? comment + begin : begin).starts_with(text);
  const bool is_titled = text_of(beside, title_file) == title + "\n";
  if (!is_new && !(is_commented ? text.starts_with(comment + begin) : is_titled)) refuse_other(path);
  if (!is_titled) write_file(beside, title + "\n");
  if (is_commented) write_file(path, is_new ? begin : text.substr(comment.size()));
  return {path, begin};
}

void CsvFile::reject_line(std::size_t line_index, std::string_view reason) const {
  const auto above = static_cast<std::size_t>(std::ranges::count(begin_, '\n'));
  throw InputError(
      fmt::format("{}:{}:1: {}; delete the line to measure it again", path_.native(), above + line_index + 1, reason));
}

void CsvFile::append(const std::string& line) const {
  Descriptor file(::open(path_.c_str(), O_WRONLY | O_APPEND | O_NOFOLLOW | O_CLOEXEC));
  if (!file.is_open()) fail_to_write(path_, last_error());
  const off_t end = ::lseek(file.number(), 0, SEEK_END);
  std::error_code error = end < 0 ? last_error() : write_all(file, line + "\n");
  if (!error) error = sync(file);
  // If truncating fails, the next start removes the partial line.
  if (error && end >= 0) static_cast<void>(::ftruncate(file.number(), end));
  if (!error) error = file.close();
  if (error) fail_to_write(path_, error);
}

void CsvFile::replace(const std::vector<std::string>& lines) const {
  std::string text = begin_;
  for (const std::string& line : lines) text += line + "\n";
  write_file(path_, text);
}

std::vector<std::string> split_cells(std::string_view line) {
  if (line.find_first_of("\n\r") != std::string_view::npos)
    throw InputError("the line contains a line break, perhaps from an editor that ends lines with CR LF");
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
  if (quoted) throw InputError("a quote is not closed");
  return cells;
}

std::string_view first_cells(std::string_view line, std::size_t cell_count) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] == ',' && !quoted && --cell_count == 0) return line.substr(0, i);
  }
  return line;
}

std::string to_cell(const std::string& text) {
  if (text.find_first_of("\n\r") != std::string::npos)
    throw InputError("'" + text + "': a table cell cannot hold a line break; choose another name");
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

}  // namespace csgsim::studies
