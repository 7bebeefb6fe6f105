// Inputs of studies: lines of their tables, and lists of numbers and names on the command line.

#include <algorithm>
#include <string>
#include <vector>

#include "sim/session/options/lists.h"
#include "sim/studies/compare/measure.h"
#include "sim/studies/corpus/measure.h"
#include "sim/studies/csv.h"
#include "sim/studies/design/row.h"
#include "sim/studies/row_text.h"
#include "sim/studies/subdivide/measure.h"
#include "tests/fuzz/property.h"

namespace fuzz = csgsim::fuzz;
namespace session = csgsim::session;
namespace studies = csgsim::studies;

namespace {

/// Checks the input in one way; an error must be one line, and must not occur for input that was already accepted.
template <class Read, class Check>
void look(const Read& read, const Check& check) {
  try {
    const auto found = read();
    try {
      check(found);
    } catch (const csgsim::InputError& error) {
      fuzz::broken(error.what());
    }
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error);
  }
}

void look_at_cells(const std::string& line) {
  look([&] { return studies::split_cells(line); },
       [](const std::vector<std::string>& cells) {
         std::string again;
         for (const std::string& cell : cells) again += (&cell == &cells.front() ? "" : ",") + studies::to_cell(cell);
         fuzz::require(studies::split_cells(again) == cells, "cells are read as written");
       });
}

/// Compares rows as text, since NaN does not equal itself.
template <class Row>
void look_at_row(const std::string& line) {
  look([&] { return studies::from_line<Row>(line); },
       [](const Row& row) {
         const std::string again = studies::to_line(row);
         fuzz::require(again.find('\n') == std::string::npos, "a row is one line");
         fuzz::require(studies::to_line(studies::from_line<Row>(again)) == again, "a row is read as written");
       });
}

void look_at_memory_map(const std::string& cell) {
  const auto read = [](const std::string& text) {
    studies::MemoryMap map;
    studies::from_cell(text, map);
    return map;
  };
  look([&] { return read(cell); },
       [&](const studies::MemoryMap& map) {
         const std::vector<std::string> cells = studies::split_cells(studies::to_cell(map));
         fuzz::require(cells.size() == 1 && read(cells.front()) == map, "a memory map is read as written");
       });
}

template <class Value>
bool has_doubles(std::vector<Value> values) {
  std::ranges::sort(values);
  return std::ranges::adjacent_find(values) != values.end();
}

void look_at_lists(const std::string& text) {
  constexpr unsigned least = 3;
  constexpr unsigned most = 300;
  look([&] { return session::parse_numbers(text, least, most); },
       [](const std::vector<unsigned>& values) {
         const auto within = [](unsigned value) { return value >= least && value <= most; };
         fuzz::require(!values.empty() && std::ranges::all_of(values, within), "numbers are within their range");
         fuzz::require(!has_doubles(values), "no number occurs twice");
       });
  const std::vector<std::string> known{"stack", "list", "bits"};
  look([&] { return session::parse_names(text, "strategy", known); },
       [&](const std::vector<std::string>& names) {
         const auto is_known = [&](const std::string& name) { return std::ranges::count(known, name) == 1; };
         fuzz::require(!names.empty() && std::ranges::all_of(names, is_known), "names are known");
         fuzz::require(!has_doubles(names), "no name occurs twice");
       });
}

}  // namespace

/// Any line is read and written unchanged, or gives one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const std::string line(text.substr(0, text.find('\n')));
  look_at_cells(line);
  look_at_row<studies::Measurement>(line);
  look_at_row<studies::ComparisonRow>(line);
  look_at_row<studies::SweepRow>(line);
  look_at_row<studies::CorpusRow>(line);
  look_at_row<studies::SubdivideRow>(line);
  look_at_memory_map(line);
  look_at_lists(line);
  return 0;
}
