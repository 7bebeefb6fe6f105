#include "sim/study/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

#include "hw/isa/error.h"

namespace csgsim::study {

namespace {

/// Calls visit(name, member) for every column, in order.
template <typename Row, typename Visitor>
void describe(Row& row, Visitor&& visit) {
  visit("knob", row.knob);
  visit("value", row.value);
  visit("clocks", row.clocks);
  visit("simulated_seconds", row.simulated_seconds);
  visit("halfspaces", row.halfspaces);
  visit("memory_bits", row.memory_bits);
  visit("covered", row.covered);
  visit("wrong", row.wrong);
  visit("wrong_silhouette", row.wrong_silhouette);
  visit("wrong_owner", row.wrong_owner);
  visit("unexplained", row.unexplained);
  visit("depth_max", row.depth_max);
  visit("depth_p999", row.depth_p999);
  visit("depth_max_steps", row.depth_max_steps);
  visit("depth_p999_steps", row.depth_p999_steps);
  visit("facet_wrong", row.facet_wrong);
  visit("facet_depth_p999", row.facet_depth_p999);
  visit("picture_difference", row.picture_difference);
}

std::string header() {
  std::string line;
  const Measurement none;
  describe(none, [&](const char* name, const auto&) { line += (line.empty() ? "" : ",") + std::string(name); });
  return line + "\n";
}

std::string to_line(const Measurement& row) {
  std::string line;
  bool first = true;
  describe(row, [&](const char*, const auto& member) {
    line += fmt::format("{}{}", first ? "" : ",", member);
    first = false;
  });
  return line + "\n";
}

void read_cell(const std::string& cell, std::string& member) { member = cell; }

template <typename Number>
void read_cell(const std::string& cell, Number& member) {
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), member);
  if (error != std::errc{} || end != cell.data() + cell.size()) throw InputError("'" + cell + "' is no number");
}

Measurement from_line(const std::string& line) {
  Measurement row;
  std::istringstream cells(line);
  describe(row, [&](const char* name, auto& member) {
    std::string cell;
    if (!std::getline(cells, cell, ',')) throw InputError(std::string("there is no ") + name);
    read_cell(cell, member);
  });
  return row;
}

}  // namespace

Table::Table(std::filesystem::path path, const std::string& title) : path_(std::move(path)) {
  const std::string begin = "# " + title + "\n" + header();
  std::ifstream file(path_, std::ios::binary);
  if (!file) {
    write(begin, false);
    return;
  }
  std::stringstream whole;
  whole << file.rdbuf();
  std::string text = whole.str();
  if (!text.starts_with(begin)) {
    throw InputError(path_.string() +
                     ": holds another study; give this one a place of its own with -o, or delete that");
  }
  // An interrupted write may have left part of a line.
  const std::size_t whole_lines = text.rfind('\n') + 1;
  if (whole_lines < text.size()) write(text.substr(0, whole_lines), false);
  std::istringstream lines(text.substr(begin.size(), whole_lines - begin.size()));
  std::size_t number = 2;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    try {
      rows_.push_back(from_line(line));
    } catch (const InputError& error) {
      throw InputError(
          fmt::format("{}:{}:1: {}; delete the line to have it measured anew", path_.string(), number, error.what()));
    }
  }
}

const Measurement* Table::find(const Settings& settings) const {
  const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const Measurement& row) {
    return row.knob == settings.knob && row.value == settings.value;
  });
  return found == rows_.end() ? nullptr : &*found;
}

void Table::add(const Measurement& measurement) {
  write(to_line(measurement), true);
  rows_.push_back(measurement);
}

void Table::write(const std::string& text, bool append) const {
  std::ofstream file(path_, std::ios::binary | (append ? std::ios::app : std::ios::trunc));
  file << text << std::flush;
  if (!file) throw InputError(path_.string() + ": cannot be written; is there room, and may you write there?");
}

nlohmann::ordered_json to_json(const Measurement& measurement) {
  nlohmann::ordered_json json;
  describe(measurement, [&](const char* name, const auto& member) { json[name] = member; });
  return json;
}

}  // namespace csgsim::study
