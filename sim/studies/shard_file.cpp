#include "sim/studies/shard_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <random>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/folder.h"
#include "hw/base/input_file.h"

namespace csgsim::studies {

namespace {

namespace fs = std::filesystem;

constexpr InputKind shard_input{"a shard's file", std::size_t{256} << 20U, "use more shards"};

constexpr std::string_view mark = "csgsim shard";
constexpr std::string_view command_mark = "# command,";
constexpr std::string_view point_column = "point,";
constexpr std::string_view ending = ".shard";
constexpr std::string_view former_ending = ".csv";

/// Number of cells in the first line before the words of the command.
constexpr std::size_t cells_before_words = 7;

std::string title_of(const ShardHeader& header) {
  std::string title = fmt::format("{},{},{},{},{},{},{}", mark, header.shard.number, header.shard.count, header.points,
                                  to_cell(header.inputs.model_hash), to_cell(header.inputs.machine_hash),
                                  to_cell(header.inputs.csgsim));
  for (const std::string& word : header.words) title += "," + to_cell(word);
  return title;
}

std::string command_line(const std::vector<std::string>& words) {
  if (words.empty()) return "";
  std::vector<std::string> cells;
  for (const std::string& word : words) cells.push_back(to_cell(word));
  return fmt::format("{}{}\n", command_mark, fmt::join(cells, ","));
}

ShardHeader parse_header(std::string_view title) {
  const std::vector<std::string> cells = split_cells(title);
  if (cells.size() <= cells_before_words || cells[0] != mark) throw InputError("this is not a shard of a study");
  ShardHeader header;
  from_cell(cells[1], header.shard.number);
  from_cell(cells[2], header.shard.count);
  header.shard = parse_shard(to_text(header.shard));
  from_cell(cells[3], header.points);
  if (header.points < 1 || header.points > max_points)
    throw InputError(fmt::format("the number of points must be from 1 to {}, not {}", max_points, header.points));
  header.inputs = {cells[4], cells[5], cells[6]};
  header.words.assign(cells.begin() + cells_before_words, cells.end());
  return header;
}

ShardLine parse_shard_line(const std::string& text, std::size_t points) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) throw InputError("the row is missing");
  ShardLine line;
  from_cell(text.substr(0, comma), line.point);
  if (line.point >= points)
    throw InputError(fmt::format("point {} does not exist among {} points", line.point, points));
  line.row = text.substr(comma + 1);
  return line;
}

/// Prefix of the names of a shard's files, such as `sweep-03-of-16.`.
std::string stem_of(const ShardHeader& header) {
  return fmt::format("{}-{:0{}}-of-{}.", header.words.front(), header.shard.number,
                     fmt::formatted_size("{}", header.shard.count), header.shard.count);
}

}  // namespace

fs::path shards_folder(const fs::path& study) { return study / "shards"; }

std::vector<fs::path> list_shard_files(const fs::path& study, const std::optional<ShardHeader>& shard) {
  const std::string stem = shard ? stem_of(*shard) : "";
  std::vector<fs::path> files;
  std::error_code error;
  for (auto entry = fs::directory_iterator(shards_folder(study), error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    const std::string name = entry->path().filename().native();
    const bool is_shard = name.ends_with(ending) || name.ends_with(former_ending);
    if (is_shard && name.starts_with(stem) && !name.starts_with('.')) files.push_back(entry->path());
  }
  const bool is_new = shard && error == std::errc::no_such_file_or_directory;
  if (error && !is_new) {
    throw InputError(
        fmt::format("{}: contains no shards of a study ({}); specify the folder that the runs with --shard had as -o",
                    study.native(), error.message()));
  }
  std::sort(files.begin(), files.end());
  return files;
}

ShardFile read_shard_file(const fs::path& path) {
  const std::string text = read_regular_file(path, shard_input);
  std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
  ShardFile file{path, {}, {}, {}, {}};
  std::size_t number = 0;
  bool has_columns = false;
  try {
    for (std::string line; std::getline(lines, line);) {
      if (++number == 1) {
        file.header = parse_header(std::string_view(line).substr(line.starts_with("# ") ? 2 : 0));
      } else if (number == 2 && line.starts_with(command_mark)) {
        file.command = split_cells(std::string_view(line).substr(command_mark.size()));
      } else if (!has_columns) {
        if (!line.starts_with(point_column)) throw InputError("these are not the columns of a shard");
        file.columns = line.substr(point_column.size());
        has_columns = true;
      } else {
        file.lines.push_back(parse_shard_line(line, file.header.points));
      }
    }
    if (!has_columns) throw InputError("the file ends before the columns of its shard");
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}:{}:1: {}; delete the file and run its shard again", path.native(),
                                 std::max<std::size_t>(number, 1), error.what()));
  }
  return file;
}

ShardWriter::ShardWriter(fs::path study, ShardHeader header, std::vector<std::string> command, std::string columns)
    : study_(std::move(study)),
      header_(std::move(header)),
      command_(std::move(command)),
      columns_(std::move(columns)) {}

void ShardWriter::add(const ShardLine& line) {
  if (!file_) {
    const fs::path folder = shards_folder(study_);
    make_folder(folder);
    std::random_device random;
    file_.emplace(folder / fmt::format("{}{:08x}{:08x}{}", stem_of(header_), random(), random(), ending),
                  fmt::format("# {}\n{}{}{}\n", title_of(header_), command_line(command_), point_column, columns_));
  }
  file_->append(fmt::format("{},{}", line.point, line.row));
}

}  // namespace csgsim::studies
