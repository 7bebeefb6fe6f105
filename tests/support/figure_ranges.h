#pragma once

#include "tests/support/test.h"

namespace csgsim::testing {

/// Valid range of one numeric key of a description.
struct FigureRange {
  std::string_view key;
  std::int64_t least;
  std::int64_t most;
  std::string_view others = "";  ///< changes of other keys, as +KEY=VALUE, that make this key's extremes valid
};

/// Checks that each key accepts its minimum and maximum and rejects the values just outside them. `load` reads a
/// description by name followed by changes.
template <class Load>
void check_figure_ranges(const std::string& name, std::span<const FigureRange> ranges, const Load& load) {
  for (const FigureRange& range : ranges) {
    CAPTURE(std::string(range.key));
    const auto refusal = [&](std::int64_t value) {
      return error_of([&] { load(fmt::format("{}{}+{}={}", name, range.others, range.key, value)); });
    };
    CHECK(refusal(range.least) == "");
    CHECK(refusal(range.most) == "");
    for (const std::int64_t beyond : {range.least - 1, range.most + 1})
      CHECK(refusal(beyond).find(fmt::format("{} is {};", range.key, beyond)) != std::string::npos);
  }
}

}  // namespace csgsim::testing
