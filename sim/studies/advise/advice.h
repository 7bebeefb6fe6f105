#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/studies/inputs.h"

namespace csgsim::studies {

/// One way to draw a model that advice may come to. Points are in the order in which they are measured and reported.
struct AdvicePoint {
  unsigned z_bits = 0;
  unsigned fraction_bits = 0;
  unsigned colour_bits = 0;
  std::string colouring;
  std::string strategy;
  unsigned stack_bits = 0;  ///< of strategy bits: m; 0 for the others
  unsigned alu_bits = 0;    ///< of the machine; 0 where its kind has no such figure

  auto operator<=>(const AdvicePoint&) const = default;

  static void columns(auto& point, const auto& visit) {
    visit("z_bits", point.z_bits);
    visit("fraction_bits", point.fraction_bits);
    visit("colour_bits", point.colour_bits);
    visit("colouring", point.colouring);
    visit("strategy", point.strategy);
    visit("stack_bits", point.stack_bits);
    visit("alu_bits", point.alu_bits);
  }
};

/// The values of each dimension, in the order in which they are to be reported.
struct AdviceRanges {
  std::vector<unsigned> z_bits;
  std::vector<unsigned> fraction_bits;
  std::vector<unsigned> colour_bits;
  std::vector<std::string> colourings;
  std::vector<std::string> strategies;
  std::vector<unsigned> stack_bits;
  std::vector<unsigned> alu_bits;
};

/// The product of the ranges; a strategy other than bits is one point for all stack bits. ALU widths vary fastest, and
/// z bits and fraction bits slowest.
std::vector<AdvicePoint> points_of(const AdviceRanges& ranges);

/// What a point takes, and how right its picture is. Where `reason` says why there is no Program, the counts are 0.
struct AdviceRow {
  static constexpr std::size_t point_columns = 7;

  AdvicePoint point;
  Inputs inputs;
  std::string reason;
  std::uint32_t used_bits = 0;            ///< a pixel, in all; the machine has just as many
  std::uint32_t classification_bits = 0;  ///< of these, that the classification uses
  std::uint64_t clocks = 0;               ///< until the picture is drawn, latency included
  std::uint64_t interval_clocks = 0;      ///< from one frame to the next
  double frames_per_second = 0;
  std::uint64_t wrong = 0;        ///< pixels that differ from the exact picture of the same half-spaces
  std::uint64_t unexplained = 0;  ///< of these, beyond the bounds that docs/numbers.md states
  /// The greatest difference of a channel from the picture with 24 bits of colour and else the same bits, of 255.
  unsigned colour_error = 0;

  [[nodiscard]] bool compiled() const { return reason.empty(); }
  bool operator==(const AdviceRow&) const = default;

  static void columns(auto& row, const auto& visit) {
    AdvicePoint::columns(row.point, visit);
    Inputs::columns(row.inputs, visit);
    visit("used_bits", row.used_bits);
    visit("classification_bits", row.classification_bits);
    visit("clocks", row.clocks);
    visit("interval_clocks", row.interval_clocks);
    visit("frames_per_second", row.frames_per_second);
    visit("wrong", row.wrong);
    visit("unexplained", row.unexplained);
    visit("colour_error", row.colour_error);
    visit("reason", row.reason);
  }
};

/// As `stack`, or `bits 5`.
std::string strategy_name(const AdvicePoint& point);

/// What is asked of a choice. Limits are included.
struct Wishes {
  std::uint32_t max_bits = 0;          ///< of memory a pixel
  std::uint64_t max_wrong_pixels = 0;  ///< of the picture
  double min_fps = 0;                  ///< frames a second
  unsigned min_colour_bits = 0;
};

enum class Wish : std::uint8_t { bits, wrong_pixels, speed, colour };

inline constexpr Wish all_wishes[] = {Wish::bits, Wish::wrong_pixels, Wish::speed, Wish::colour};

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

/// As `fewest bits`.
std::string recommendation_name(Wish wish);

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

/// A file of advice: wishes, what is recommended, the front and all points.
std::string advice_json(const std::string& title, const Wishes& wishes, std::span<const AdviceRow> rows,
                        const Advice& advice);

}  // namespace csgsim::studies
