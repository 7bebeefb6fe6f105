#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hw/machines/machine.h"
#include "sim/session/model/model_request.h"

namespace csgsim::studies {

/// Designs that one command may ask for.
inline constexpr std::uint32_t most_designs = 10'000;

/// A figure of the machine, or an option of render, that takes several values.
struct Dimension {
  std::string key;
  std::vector<std::string> values;

  bool operator==(const Dimension&) const = default;
};

/// Reads KEY=a,b,c, where a value may be a range of numbers, 3..8. Throws InputError.
Dimension dimension_in(const std::string& text);

/// The options of render that may be varied beside figures, by their names.
std::vector<std::string> varied_options();

/// Whether the figure says how many memory bits a pixel of its machine has.
bool is_memory_figure(std::string_view key);

/// Gives the figure, or the option, that value. Throws InputError, or UsageError, for a value that the option does not
/// take; figures are looked at when the machine is loaded.
void vary(session::ModelRequest& options, const std::string& key, const std::string& value);

/// Which cells of a grid are designs.
struct GridChoice {
  std::uint32_t points = 0;  ///< so many of a sample; 0 for all
  std::uint32_t seed = 1;    ///< of the sample
};

/// Designs that are asked for: combinations of the values, each put into `base`. Combinations that draw alike, as those
/// of stack bits with a strategy that has none, are one.
class DesignGrid {
 public:
  /// Every combination, or a sample of them. Throws UsageError for a grid of more than most_designs cells where no
  /// sample is asked for, and for a value that is wrong whatever the others are.
  DesignGrid(session::ModelRequest base, std::vector<Dimension> dimensions, const GridChoice& choice);

  /// In the order in which they were asked for.
  [[nodiscard]] const std::vector<session::ModelRequest>& designs() const { return designs_; }

  /// Asks for those besides that differ from one of these, by their numbers, in one key, by the value before or behind
  /// in its list; for so many at most.
  void add_neighbours(std::span<const std::size_t> designs, std::size_t most);

 private:
  using Cell = std::vector<std::size_t>;  ///< a place in the list of each dimension

  void add_all();
  void add_sample(const GridChoice& choice);
  void add(Cell cell);

  session::ModelRequest base_;
  std::vector<Dimension> dimensions_;
  std::vector<std::size_t> sizes_;
  std::vector<session::ModelRequest> designs_;
  std::vector<Cell> cells_;      ///< of the designs
  std::set<std::string> known_;  ///< what tells them apart
};

}  // namespace csgsim::studies
