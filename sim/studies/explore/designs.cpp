#include "sim/studies/explore/designs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "host/emit/curves.h"
#include "hw/base/error.h"
#include "hw/base/nearest.h"
#include "hw/base/text.h"
#include "hw/isa/instruction.h"
#include "hw/kinds/load.h"
#include "hw/machines/kind.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/prunings.h"
#include "sim/session/options/sets.h"
#include "sim/session/options/usage.h"
#include "sim/studies/dimensions.h"
#include "sim/studies/explore/sample.h"

namespace csgsim::studies {

using namespace session;

namespace {

constexpr std::size_t most_values = 1000;  ///< of a dimension
constexpr unsigned most_number = 2'000'000'000;

unsigned number_of(const std::string& text, unsigned least, unsigned most) {
  const std::vector<unsigned> numbers = parse_numbers(text, least, most);
  if (numbers.size() != 1) throw InputError("'" + printable(text) + "' is no number");
  return numbers.front();
}

template <class Choices>
std::string word_of(const std::string& text, const char* kind, const Choices& choices) {
  return parse_names(text, kind, fixed_names_of(choices)).at(0);
}

/// An option of render that may be varied.
struct VariedOption {
  std::string_view name;
  void (*put)(ModelRequest& options, const std::string& value);
};

constexpr VariedOption options_by_name[] = {
    {"size", [](ModelRequest& options, const std::string& value) { options.size = value; }},
    {"memory-bits", [](ModelRequest& options,
                       const std::string& value) { options.memory_bits = number_of(value, 1, isa::max_memory_bits); }},
    {"z-bits",
     [](ModelRequest& options, const std::string& value) {
       options.z_bits = number_of(value, view::fewest_z_bits, view::most_z_bits);
     }},
    {"fraction-bits",
     [](ModelRequest& options, const std::string& value) {
       options.fraction_bits = number_of(value, 0, view::most_fraction_bits);
     }},
    {"colour-bits",
     [](ModelRequest& options, const std::string& value) {
       options.colour_bits = number_of(value, isa::fewest_colour_bits, isa::most_colour_bits);
     }},
    {"strategy", [](ModelRequest& options,
                    const std::string& value) { options.strategy = word_of(value, "strategy", emit::strategies); }},
    {"stack-bits",
     [](ModelRequest& options, const std::string& value) {
       options.stack_bits = number_of(value, emit::fewest_stack_bits, most_stack_bits);
     }},
    {"colouring", [](ModelRequest& options,
                     const std::string& value) { options.colouring = word_of(value, "colouring", emit::colourings); }},
    {"curves",
     [](ModelRequest& options, const std::string& value) {
       options.curves = parse_names(value, "way", names_of(emit::curve_choices)).at(0);
     }},
    {"pruning",
     [](ModelRequest& options, const std::string& value) {
       static_cast<void>(pruning_of(value));
       options.pruning = value;
     }},
};

const VariedOption* varied_option(std::string_view key) {
  const auto* const found = std::ranges::find(options_by_name, key, &VariedOption::name);
  return found == std::end(options_by_name) ? nullptr : found;
}

/// A range of numbers as its numbers; all else as it is.
std::vector<std::string> values_in(const std::string& word) {
  const std::size_t dots = word.find("..");
  const bool is_range = dots != word.npos && dots > 0 && word.find_first_not_of("0123456789.") == word.npos;
  if (!is_range) return {word};
  const unsigned first = number_of(word.substr(0, dots), 0, most_number);
  const unsigned last = number_of(word.substr(dots + 2), 0, most_number);
  if (last < first) throw InputError(fmt::format("'{}' runs backwards; take {}..{}", word, last, first));
  if (last - first >= most_values) throw InputError(fmt::format("'{}' is more than {} values", word, most_values));
  std::vector<std::string> values;
  for (unsigned number = first; number <= last; ++number) values.push_back(std::to_string(number));
  return values;
}

[[noreturn]] void fail_key(const Dimension& dimension, const machines::Machine& machine) {
  std::vector<std::string_view> known;
  for (const machines::FigureSchema& figure : machine.kind->schema) known.push_back(figure.key);
  for (const VariedOption& option : options_by_name) known.push_back(option.name);
  throw UsageError("--vary", fmt::format("'{}' is neither a figure of {} nor one of {}; the nearest known is '{}'",
                                         printable(dimension.key), printable(machine.name),
                                         fmt::join(varied_options(), ", "), nearest(dimension.key, known)));
}

const machines::FigureSchema* figure_of(const machines::Machine& machine, std::string_view key) {
  const auto found = std::ranges::find(machine.kind->schema, key, &machines::FigureSchema::key);
  return found == machine.kind->schema.end() ? nullptr : &*found;
}

/// The base with the last value of every figure but that one: what does not fit the base may fit these.
ModelRequest with_others(const ModelRequest& base, std::span<const Dimension> dimensions, const Dimension& but) {
  ModelRequest one = base;
  for (const Dimension& dimension : dimensions) {
    if (dimension.key != but.key && varied_option(dimension.key) == nullptr)
      vary(one, dimension.key, dimension.values.back());
  }
  return one;
}

bool is_possible(const ModelRequest& base, const std::string& key, const std::string& value) {
  try {
    ModelRequest one = base;
    vary(one, key, value);
    static_cast<void>(machine_of(one));
  } catch (const InputError&) {
    return false;
  } catch (const UsageError&) {
    return false;
  }
  return true;
}

/// The design has that value, whatever the others are; what is wrong with it is wrong with --vary.
ModelRequest varied_once(const ModelRequest& base, const std::string& key, const std::string& value) {
  ModelRequest one = base;
  const auto fail = [&](const char* why) { throw UsageError("--vary " + printable(key), why); };
  try {
    vary(one, key, value);
    static_cast<void>(machine_of(one));
  } catch (const InputError& error) {
    fail(error.what());
  } catch (const UsageError& error) {
    fail(error.what());
  }
  return one;
}

/// Each key has to be known, once.
void check_keys(const machines::Machine& machine, std::span<const Dimension> dimensions) {
  std::set<std::string> keys;
  for (const Dimension& dimension : dimensions) {
    if (figure_of(machine, dimension.key) == nullptr && varied_option(dimension.key) == nullptr)
      fail_key(dimension, machine);
    if (!keys.insert(dimension.key).second)
      throw UsageError("--vary", "'" + dimension.key + "' is said twice; give all values at once");
  }
}

/// Each value has to be possible by itself, or with the last values of the other figures, and a figure's may not be
/// what an option says otherwise: --size, or --memory-bits.
void check(const ModelRequest& base, std::span<const Dimension> dimensions) {
  const machines::Machine machine = machine_of(base);
  check_keys(machine, dimensions);
  ModelRequest with_options = base;
  for (const Dimension& dimension : dimensions) {
    if (varied_option(dimension.key) == nullptr) continue;
    for (const std::string& value : dimension.values) varied_once(base, dimension.key, value);
    vary(with_options, dimension.key, dimension.values.front());
  }
  for (const Dimension& dimension : dimensions) {
    const machines::FigureSchema* const figure = figure_of(machine, dimension.key);
    if (figure == nullptr) continue;
    for (const std::string& value : dimension.values) {
      const ModelRequest others = with_others(with_options, dimensions, dimension);
      const bool fits_others =
          !is_possible(with_options, dimension.key, value) && is_possible(others, dimension.key, value);
      const ModelRequest one = varied_once(fits_others ? others : with_options, dimension.key, value);
      if (figure->load(machine_of(one)) != figure->load(kinds::load(one.machine)))
        throw UsageError("--vary", fmt::format("an option says otherwise than {}={}; leave out --size, --memory-bits",
                                               dimension.key, value));
    }
  }
}

/// All that tells designs apart.
std::string identity_of(const ModelRequest& one) {
  const unsigned stack_bits = has_stack_bits(one.strategy) ? one.stack_bits : 0;
  return fmt::format("{} {} {} {} {} {} {} {} {} {} {}", one.machine, one.size, one.memory_bits.value_or(0), one.z_bits,
                     one.fraction_bits, one.colour_bits, one.strategy, stack_bits, one.colouring, one.curves,
                     one.pruning);
}

}  // namespace

Dimension dimension_in(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == text.npos || equals == 0)
    throw InputError("'" + printable(text) + "' varies nothing; say KEY=a,b,c, as in alu.bits=1,2,4");
  Dimension dimension{text.substr(0, equals), {}};
  for (const std::string& word : parse_words(text.substr(equals + 1))) {
    for (std::string& value : values_in(word)) {
      if (std::ranges::find(dimension.values, value) == dimension.values.end())
        dimension.values.push_back(std::move(value));
    }
  }
  if (dimension.values.size() > most_values)
    throw InputError(fmt::format("{} has more than {} values", printable(dimension.key), most_values));
  return dimension;
}

std::vector<std::string> varied_options() {
  std::vector<std::string> names;
  for (const VariedOption& option : options_by_name) names.emplace_back(option.name);
  return names;
}

bool is_memory_figure(std::string_view key) {
  constexpr std::string_view figures[] = {"array.memory_bits", "pixel.memory_bits", "cells.words", "cells.word_bits"};
  return std::ranges::find(figures, key) != std::end(figures);
}

void vary(ModelRequest& options, const std::string& key, const std::string& value) {
  if (const VariedOption* const option = varied_option(key)) return option->put(options, value);
  options.machine += fmt::format("+{}={}", key, value);
}

DesignGrid::DesignGrid(ModelRequest base, std::vector<Dimension> dimensions, const GridChoice& choice)
    : base_(std::move(base)), dimensions_(std::move(dimensions)) {
  check(base_, dimensions_);
  double cells = 1;
  for (const Dimension& dimension : dimensions_) {
    sizes_.push_back(dimension.values.size());
    cells *= static_cast<double>(sizes_.back());
  }
  const auto most = static_cast<double>(most_designs);
  if (choice.points == 0 && cells > most)
    throw UsageError("--vary", fmt::format("that are {:.0f} designs, {} at most; take --points N for a sample of them",
                                           cells, grouped(most_designs)));
  if (cells > 1e18) throw UsageError("--vary", "that are more than 10^18 designs; vary fewer figures");
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

/// Unless there is one that draws alike.
void DesignGrid::add(Cell cell) {
  ModelRequest one = base_;
  for (std::size_t axis = 0; axis < cell.size(); ++axis)
    vary(one, dimensions_[axis].key, dimensions_[axis].values[cell[axis]]);
  if (!known_.insert(identity_of(one)).second) return;
  designs_.push_back(std::move(one));
  cells_.push_back(std::move(cell));
}

void DesignGrid::add_neighbours(std::span<const std::size_t> designs, std::size_t most) {
  const std::size_t end = designs_.size() + most;
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
