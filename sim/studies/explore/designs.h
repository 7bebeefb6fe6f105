#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hw/machines/machine.h"
#include "sim/shell/model_options.h"

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
void vary(shell::ModelOptions& options, const std::string& key, const std::string& value);

/// Which cells of a grid are designs.
struct GridChoice {
  std::uint32_t points = 0;  ///< so many of a sample; 0 for all
  std::uint32_t seed = 1;    ///< of the sample
};

/// Every combination of the values, or a sample of them, each put into `base`; combinations that draw alike, as those
/// of stack bits with a strategy that has none, are one. Throws UsageError for a grid of more than most_designs cells
/// where no sample is asked for, and for a value that is wrong whatever the others are.
std::vector<shell::ModelOptions> designs_of(const shell::ModelOptions& base, std::span<const Dimension> dimensions,
                                            const GridChoice& choice);

}  // namespace csgsim::studies
