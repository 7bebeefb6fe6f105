#include "sim/suite/compare.h"

#include <algorithm>

namespace csgsim::suite {

namespace {

/// An expected row, and the widest scope in which another row agrees with it.
struct Standard {
  const Row* row = nullptr;
  Scope scope = Scope::machine;
};

Standard standard_for(std::span<const Row> expected, const Row& found) {
  if (const Row* const same = find_row(expected, found.name(), found.machine())) return {same, Scope::machine};
  Standard standard;
  for (const Row& row : expected) {
    if (row.name() != found.name()) continue;
    const bool has_same_program = !found.at("program").empty() && row.at("program") == found.at("program");
    if (has_same_program) return {&row, Scope::program};
    if (standard.row == nullptr) standard = {&row, Scope::picture};
  }
  return standard;
}

}  // namespace

Comparison compare(std::span<const Row> expected, const Row& found) {
  const Standard standard = standard_for(expected, found);
  Comparison comparison;
  if (standard.row == nullptr) return comparison;
  for (std::size_t i = 0; i < columns().size(); ++i) {
    const Column& column = columns()[i];
    const std::string& wanted = standard.row->cells[i];
    const std::string& value = found.cells[i];
    if (column.scope == Scope::run || column.scope > standard.scope || wanted.empty() || value.empty()) continue;
    ++comparison.values;
    if (wanted != value) comparison.differences.push_back({found.name(), found.machine(), column.name, wanted, value});
  }
  return comparison;
}

}  // namespace csgsim::suite
