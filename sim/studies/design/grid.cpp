#include "sim/studies/design/grid.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "hw/base/error.h"
#include "hw/base/nearest.h"
#include "hw/base/text.h"
#include "hw/kinds/load.h"
#include "hw/machines/kind.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/usage.h"
#include "sim/studies/design/axes.h"
#include "sim/studies/dimensions.h"

namespace csgsim::studies {

namespace {

using session::ModelRequest;
using session::UsageError;

constexpr std::size_t max_values = 1000;  ///< per dimension
constexpr unsigned max_number = 2'000'000'000;

unsigned parse_grid_number(const std::string& text, unsigned minimum, unsigned maximum) {
  const std::vector<unsigned> numbers = session::parse_numbers(text, minimum, maximum);
  if (numbers.size() != 1) throw InputError("'" + text + "' is not a single number; give one value");
  return numbers.front();
}

/// Expands a range of numbers; returns any other word unchanged.
std::vector<std::string> parse_values(const std::string& word) {
  const std::size_t dots = word.find("..");
  const bool is_range = dots != word.npos && dots > 0 && word.find_first_not_of("0123456789.") == word.npos;
  if (!is_range) return {word};
  const unsigned first = parse_grid_number(word.substr(0, dots), 0, max_number);
  const unsigned last = parse_grid_number(word.substr(dots + 2), 0, max_number);
  if (last < first) throw InputError(fmt::format("range '{}' is reversed; use {}..{}", word, last, first));
  if (last - first >= max_values)
    throw InputError(fmt::format("range '{}' has more than {} values; use a shorter range", word, max_values));
  std::vector<std::string> values;
  for (unsigned number = first; number <= last; ++number) values.push_back(std::to_string(number));
  return values;
}

[[noreturn]] void fail_key(const Dimension& dimension, const machines::Machine& machine) {
  std::vector<std::string_view> known;
  for (const machines::FigureSchema& figure : machine.kind->schema) known.push_back(figure.key);
  for (const Axis& axis : axes()) known.push_back(axis.key);
  throw UsageError("--vary",
                   fmt::format("'{}' is neither a parameter of {} nor one of {}; did you mean '{}'?", dimension.key,
                               machine.name, fmt::join(axis_keys(), ", "), nearest(dimension.key, known)));
}

const machines::FigureSchema* figure_of(const machines::Machine& machine, std::string_view key) {
  const auto found = std::ranges::find(machine.kind->schema, key, &machines::FigureSchema::key);
  return found == machine.kind->schema.end() ? nullptr : &*found;
}

/// The base with the last value of every other parameter: a value that does not fit the base may fit these.
ModelRequest with_others(const ModelRequest& base, std::span<const Dimension> dimensions, const Dimension& but) {
  ModelRequest one = base;
  for (const Dimension& dimension : dimensions) {
    if (dimension.key != but.key && find_axis(dimension.key) == nullptr)
      set_option(one, dimension.key, dimension.values.back());
  }
  return one;
}

/// Why the design cannot have that value; empty if it can.
std::string why_not(ModelRequest one, const std::string& key, const std::string& value) {
  return session::check_by_parsing([&](const std::string& text) {
    set_option(one, key, text);
    static_cast<void>(session::machine_of(one));
  })(value);
}

/// Returns the design with that value. Throws UsageError of --vary if it is invalid.
ModelRequest with_checked_value(const ModelRequest& base, const std::string& key, const std::string& value) {
  if (const std::string why = why_not(base, key, value); !why.empty()) throw UsageError("--vary " + key, why);
  ModelRequest one = base;
  set_option(one, key, value);
  return one;
}

/// Throws UsageError for unknown or repeated keys.
void check_keys(const machines::Machine& machine, std::span<const Dimension> dimensions) {
  std::set<std::string> keys;
  for (const Dimension& dimension : dimensions) {
    if (figure_of(machine, dimension.key) == nullptr && find_axis(dimension.key) == nullptr)
      fail_key(dimension, machine);
    if (!keys.insert(dimension.key).second)
      throw UsageError("--vary", "'" + dimension.key + "' is given twice; list all its values once");
  }
}

/// Checks that each value is possible with the base, or with the last values of the other parameters, and that no
/// option such as --size or --memory-bits overrides a varied parameter.
void check(const ModelRequest& base, std::span<const Dimension> dimensions) {
  const machines::Machine machine = session::machine_of(base);
  check_keys(machine, dimensions);
  ModelRequest with_options = base;
  for (const Dimension& dimension : dimensions) {
    if (find_axis(dimension.key) == nullptr) continue;
    for (const std::string& value : dimension.values) with_checked_value(base, dimension.key, value);
    set_option(with_options, dimension.key, dimension.values.front());
  }
  for (const Dimension& dimension : dimensions) {
    const machines::FigureSchema* const figure = figure_of(machine, dimension.key);
    if (figure == nullptr) continue;
    for (const std::string& value : dimension.values) {
      const ModelRequest others = with_others(with_options, dimensions, dimension);
      const bool fits_others =
          !why_not(with_options, dimension.key, value).empty() && why_not(others, dimension.key, value).empty();
      const ModelRequest one = with_checked_value(fits_others ? others : with_options, dimension.key, value);
      if (figure->load(session::machine_of(one)) != figure->load(kinds::load(one.machine)))
        throw UsageError("--vary",
                         fmt::format("an option overrides {}={}; omit --size or --memory-bits", dimension.key, value));
    }
  }
}

/// Number of consecutive repeated cells after which the remaining cells are enumerated in grid order.
constexpr unsigned max_repeats = 64;

/// The root above 1 of x^(axes + 1) = x + 1.
double root_of(std::size_t axes) {
  double x = 2;
  for (int i = 0; i < 64; ++i) x = std::pow(1 + x, 1.0 / static_cast<double>(axes + 1));
  return x;
}

/// A bit mixer: the finaliser of SplitMix64 (Steele, Lea and Flood 2014).
std::uint64_t mix_bits(std::uint64_t number) {
  number += 0x9e3779b97f4a7c15U;
  number = (number ^ number >> 30U) * 0xbf58476d1ce4e5b9U;
  number = (number ^ number >> 27U) * 0x94d049bb133111ebU;
  return number ^ number >> 31U;
}

/// floor(values * p) for p = place / 2^64 rounded down to 32 bits; `values` is less than 2^32.
std::size_t value_at(std::uint64_t place, std::size_t values) {
  return static_cast<std::size_t>((place >> 32U) * std::uint64_t{values} >> 32U);
}

}  // namespace

std::vector<std::size_t> grid_cell(const std::vector<std::size_t>& sizes, std::uint64_t number) {
  std::vector<std::size_t> values(sizes.size());
  for (std::size_t axis = sizes.size(); axis-- > 0;) {
    values[axis] = static_cast<std::size_t>(number % sizes[axis]);
    number /= sizes[axis];
  }
  return values;
}

GridSequence::GridSequence(std::vector<std::size_t> sizes, std::uint64_t seed) : sizes_(std::move(sizes)) {
  const double root = root_of(sizes_.size());
  double part = 1;
  for (std::size_t axis = 0; axis < sizes_.size(); ++axis) {
    part /= root;
    // The last bits of a power differ between libraries; the upper half suffices here.
    steps_.push_back(static_cast<std::uint64_t>(std::llround(std::ldexp(part, 32))) << 32U);
    places_.push_back(mix_bits(mix_bits(seed) + axis));
    cells_ *= sizes_[axis];
  }
}

std::uint64_t GridSequence::draw_cell() {
  std::uint64_t cell = 0;
  for (std::size_t axis = 0; axis < sizes_.size(); ++axis) {
    places_[axis] += steps_[axis];
    cell = cell * sizes_[axis] + value_at(places_[axis], sizes_[axis]);
  }
  return cell;
}

std::optional<std::vector<std::size_t>> GridSequence::next() {
  if (visited_.size() == cells_) return std::nullopt;
  for (unsigned i = 0; first_untried_ == 0 && i < max_repeats; ++i) {
    const std::uint64_t cell = draw_cell();
    if (visited_.insert(cell).second) return grid_cell(sizes_, cell);
  }
  while (!visited_.insert(first_untried_).second) ++first_untried_;
  return grid_cell(sizes_, first_untried_++);
}

Dimension parse_dimension(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == text.npos || equals == 0)
    throw InputError("'" + text + "' has no values; use KEY=a,b,c, as in alu.bits=1,2,4");
  Dimension dimension{text.substr(0, equals), {}};
  for (const std::string& word : session::parse_words(text.substr(equals + 1))) {
    for (std::string& value : parse_values(word)) {
      if (std::ranges::find(dimension.values, value) == dimension.values.end())
        dimension.values.push_back(std::move(value));
    }
  }
  if (dimension.values.size() > max_values)
    throw InputError(fmt::format("{} has more than {} values; list fewer", dimension.key, max_values));
  return dimension;
}

bool is_memory_figure(std::string_view key) {
  constexpr std::string_view figures[] = {"array.memory_bits", "pixel.memory_bits", "cells.words", "cells.word_bits"};
  return std::ranges::find(figures, key) != std::end(figures);
}

DesignGrid::DesignGrid(ModelRequest base, std::vector<Dimension> dimensions)
    : base_(std::move(base)), dimensions_(std::move(dimensions)) {
  for (const Dimension& dimension : dimensions_) sizes_.push_back(dimension.values.size());
  add_all();
  for (ModelRequest& design : designs_) {
    if (!has_stack_bits(design.strategy)) design.stack_bits = emit::min_stack_bits;
  }
}

DesignGrid::DesignGrid(ModelRequest base, std::vector<Dimension> dimensions, const GridChoice& choice)
    : base_(std::move(base)), dimensions_(std::move(dimensions)) {
  check(base_, dimensions_);
  double cells = 1;
  for (const Dimension& dimension : dimensions_) {
    sizes_.push_back(dimension.values.size());
    cells *= static_cast<double>(sizes_.back());
  }
  const auto limit = static_cast<double>(max_designs);
  if (choice.points == 0 && cells > limit)
    throw UsageError("--vary",
                     fmt::format("the grid has {:.0f} designs, the maximum is {}; use --points N to sample them", cells,
                                 grouped(max_designs)));
  if (cells > 1e18) throw UsageError("--vary", "the grid has more than 10^18 designs; vary fewer parameters");
  if (choice.points == 0) {
    add_all();
  } else {
    add_sample(choice);
  }
}

void DesignGrid::add_all() {
  std::uint64_t cells = 1;
  for (const std::size_t size : sizes_) cells *= size;
  for (std::uint64_t cell = 0; cell < cells; ++cell) add(grid_cell(sizes_, cell));
}

void DesignGrid::add_sample(const GridChoice& choice) {
  GridSequence sequence(sizes_, choice.seed);
  while (designs_.size() < choice.points) {
    std::optional<Cell> cell = sequence.next();
    if (!cell) break;
    add(std::move(*cell));
  }
}

/// Adds the cell's design unless one that draws the same exists.
void DesignGrid::add(Cell cell) {
  ModelRequest one = base_;
  for (std::size_t axis = 0; axis < cell.size(); ++axis)
    put(one, dimensions_[axis].key, dimensions_[axis].values[cell[axis]]);
  DesignPoint point;
  for (const Axis& axis : axes()) axis.read(one, point);
  point.machine = one.machine;
  if (!known_.emplace(one.size, std::move(point)).second) return;
  designs_.push_back(std::move(one));
  cells_.push_back(std::move(cell));
}

void DesignGrid::add_neighbours(std::span<const std::size_t> designs, std::size_t max_count) {
  const std::size_t end = designs_.size() + max_count;
  for (const std::size_t design : designs) {
    const Cell here = cells_[design];
    for (std::size_t axis = 0; axis < here.size(); ++axis) {
      for (const bool behind : {false, true}) {
        if (designs_.size() >= end) return;
        if (behind ? here[axis] + 1 == sizes_[axis] : here[axis] == 0) continue;
        Cell there = here;
        there[axis] = behind ? here[axis] + 1 : here[axis] - 1;
        add(std::move(there));
      }
    }
  }
}

}  // namespace csgsim::studies
