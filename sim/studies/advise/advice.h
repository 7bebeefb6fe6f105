#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/studies/design/row.h"

namespace csgsim::studies {

/// What is asked of a choice. Limits are included.
struct Wishes {
  std::uint32_t max_bits = 0;          ///< of memory a pixel
  std::uint64_t max_wrong_pixels = 0;  ///< of the picture
  double min_fps = 0;                  ///< frames a second
  unsigned min_colour_bits = 0;
};

enum class Wish : std::uint8_t { bits, wrong_pixels, speed, colour };

inline constexpr Wish all_wishes[] = {Wish::bits, Wish::wrong_pixels, Wish::speed, Wish::colour};

/// What a wish is about.
struct WishKind {
  const char* best;   ///< the choice that is best by it
  const char* key;    ///< of the limit, in JSON
  const char* title;  ///< of the limit, on a page
  bool is_least;      ///< whether the limit is a least one
  double (*limit)(const Wishes& wishes);
  double (*value)(const DesignRow& row);
  std::string (*limit_text)(const Wishes& wishes);
  std::string (*value_text)(const DesignRow& row);
  std::string (*miss_text)(double by);
};

const WishKind& kind_of(Wish wish);

/// How far a choice is from a wish, in the wish's unit: bits, pixels, frames a second; 0 where it is met.
double miss(const AdviceRow& row, Wish wish, const Wishes& wishes);

bool meets_all(const AdviceRow& row, const Wishes& wishes);

/// Of the choices that no other beats: none takes fewer memory bits, a narrower ALU or less time from frame to frame
/// (then fewer clocks), is less wrong or has more bits of colour without being worse in another of these. Fewest memory
/// bits first; choices that are the same in all of these are listed once.
std::vector<AdviceRow> advice_front(std::span<const AdviceRow> rows);

/// The best choice by one wish.
struct Recommendation {
  Wish wish{};
  AdviceRow row;
  double miss = 0;  ///< of the wish itself, as miss() has it
};

/// For each wish the best by it of those that meet all the others: fewest bits, fewest wrong pixels, most frames a
/// second, most bits of colour; of equals the one with fewest memory bits, the narrowest ALU, the least time, the
/// fewest wrong pixels. A wish is left out where nothing meets all the others. All are met together exactly if a
/// recommendation misses nothing.
std::vector<Recommendation> recommend(std::span<const AdviceRow> rows, const Wishes& wishes);

/// Choices that have a Program, nearest to the wishes first, so many at most: those that miss the fewest wishes, and of
/// these those whose misses are the least parts of what is wished.
std::vector<AdviceRow> nearest_choices(std::span<const AdviceRow> rows, const Wishes& wishes, std::size_t most);

/// What a search comes to.
struct Advice {
  std::vector<Recommendation> recommendations;
  std::vector<std::string> commands;   ///< that draw them
  std::optional<AdviceRow> nearest{};  ///< to the wishes, where no choice meets all
  std::string nearest_command{};
};

}  // namespace csgsim::studies
