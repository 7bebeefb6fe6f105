// Requirements of a memory design, and the choices that meet them.
// Used by csgsim advise.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/studies/design/row.h"

namespace csgsim::studies {

/// Requirements of a choice. Limits are inclusive.
struct Requirements {
  std::uint32_t max_bits = 0;          ///< memory bits per pixel
  std::uint64_t max_wrong_pixels = 0;  ///< wrong pixels of the picture
  double min_fps = 0;                  ///< frames per second
  unsigned min_colour_bits = 0;
};

enum class Requirement : std::uint8_t { bits, wrong_pixels, speed, colour };

inline constexpr Requirement all_requirements[] = {Requirement::bits, Requirement::wrong_pixels, Requirement::speed,
                                                   Requirement::colour};

/// Description of a requirement.
struct RequirementKind {
  const char* best;   ///< name of the choice that is best by this requirement
  const char* key;    ///< key of the limit in JSON
  const char* title;  ///< title of the limit on a page
  bool is_minimum;    ///< whether the limit is a minimum
  double (*limit)(const Requirements& requirements);
  double (*value)(const DesignRow& row);
  std::string (*limit_text)(const Requirements& requirements);
  std::string (*value_text)(const DesignRow& row);
  std::string (*miss_text)(double by);  ///< such as `6 bits too many`
};

const RequirementKind& kind_of(Requirement requirement);

/// How far a choice misses a requirement, in the requirement's unit (bits, pixels, frames/s); 0 if it is met.
double miss(const AdviceRow& row, Requirement requirement, const Requirements& requirements);

bool meets_all(const AdviceRow& row, const Requirements& requirements);

/// The Pareto front in memory bits, ALU width, time between frames (then clocks), wrong pixels and colour bits. Fewest
/// memory bits first; choices that are equal in all of these are listed once.
std::vector<AdviceRow> advice_front(std::span<const AdviceRow> rows);

/// The best choice by one requirement.
struct Recommendation {
  Requirement requirement{};
  AdviceRow row;
  double miss = 0;  ///< how far the choice misses `requirement`, as returned by miss()
};

/// The best choice for each requirement among those that meet all others: fewest bits, fewest wrong pixels, highest
/// frame rate, most colour bits. Ties are broken by memory bits, ALU width, time, and wrong pixels. A requirement is
/// omitted if no choice meets all others. If some choice meets all requirements, every recommendation does; otherwise
/// each misses its own requirement.
std::vector<Recommendation> recommend(std::span<const AdviceRow> rows, const Requirements& requirements);

/// Up to `max_count` choices that have a Program, closest to the requirements first: those that miss the fewest
/// requirements, and among these those with the smallest relative misses.
std::vector<AdviceRow> nearest_choices(std::span<const AdviceRow> rows, const Requirements& requirements,
                                       std::size_t max_count);

/// Result of a search.
struct Advice {
  std::vector<Recommendation> recommendations;
  std::vector<std::string> commands;   ///< commands that render the recommendations
  std::optional<AdviceRow> nearest{};  ///< closest to the requirements, if no choice meets all
  std::string nearest_command{};
};

}  // namespace csgsim::studies
