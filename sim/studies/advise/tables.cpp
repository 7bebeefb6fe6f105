#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

#include "hw/base/text.h"
#include "sim/session/options/numbers.h"
#include "sim/studies/advise/show.h"

namespace csgsim::studies {

namespace {

/// Of the front that are printed; files have all.
constexpr std::size_t most_rows = 40;

/// Rounded up in the last place, so that what is missed never shows as 0.
std::string fps_missed(double by) { return fmt::format("{:.2f}", std::ceil(by * 100.0) / 100.0); }

std::string miss_text(Wish wish, double by) {
  switch (wish) {
    case Wish::bits: return session::counted(static_cast<std::uint64_t>(by), "bit") + " too many";
    case Wish::wrong_pixels: return session::counted(static_cast<std::uint64_t>(by), "wrong pixel") + " too many";
    case Wish::speed: return fps_missed(by) + " frames a second too few";
    case Wish::colour: return session::counted(static_cast<std::uint64_t>(by), "bit") + " of colour too few";
  }
  return {};
}

std::string wish_text(Wish wish, const Wishes& wishes) {
  switch (wish) {
    case Wish::bits: return fmt::format("at most {} a pixel", session::counted(wishes.max_bits, "bit"));
    case Wish::wrong_pixels: return "at most " + session::counted(wishes.max_wrong_pixels, "wrong pixel");
    case Wish::speed:
      return wishes.min_fps > 0 ? fmt::format("at least {:g} frames a second", wishes.min_fps) : "any speed";
    case Wish::colour: return fmt::format("at least {} of colour", session::counted(wishes.min_colour_bits, "bit"));
  }
  return {};
}

/// What is best by the wish.
std::string value_text(Wish wish, const AdviceRow& row) {
  switch (wish) {
    case Wish::bits: return fmt::format("{} a pixel", session::counted(row.used_bits, "bit"));
    case Wish::wrong_pixels: return session::counted(row.wrong, "wrong pixel");
    case Wish::speed: return fmt::format("{:.2f} frames a second", row.frames_per_second);
    case Wish::colour: return fmt::format("{} of colour", session::counted(row.point.colour_bits, "bit"));
  }
  return {};
}

std::string figures_text(const AdviceRow& row) {
  return fmt::format("{}, {}, {}, {} clocks, {}", value_text(Wish::bits, row), value_text(Wish::wrong_pixels, row),
                     value_text(Wish::speed, row), grouped(row.clocks), value_text(Wish::colour, row));
}

/// Of a front; all of it, if none has them.
std::vector<AdviceRow> with_colours(const std::vector<AdviceRow>& front, const Wishes& wishes) {
  std::vector<AdviceRow> coloured;
  std::copy_if(front.begin(), front.end(), std::back_inserter(coloured),
               [&](const AdviceRow& row) { return miss(row, Wish::colour, wishes) == 0; });
  return coloured.empty() ? front : coloured;
}

std::string colours_text(const Wishes& wishes) {
  return fmt::format(", with {} of colour or more", session::counted(wishes.min_colour_bits, "bit"));
}

void print_row(const AdviceRow& row, bool has_alu, bool meets) {
  const AdvicePoint& point = row.point;
  fmt::print("{:>5}{:>5}{:>6}{:>8}{:>7}  {:<10}{:<13}", row.used_bits, point.z_bits, point.fraction_bits,
             point.colour_bits, row.colour_error, strategy_name(point), point.colouring);
  if (has_alu) fmt::print("{:>4}", point.alu_bits);
  fmt::print("{:>12}{:>10.2f}{:>9}{}\n", grouped(row.clocks), row.frames_per_second, grouped(row.wrong),
             meets ? "  *" : "");
}

/// The first, with those of the others that are the same choice.
void print_recommendation(std::span<const Recommendation> all, const std::string& command, const Wishes& wishes) {
  const Recommendation& first = all.front();
  std::string names;
  for (const Recommendation& one : all) {
    if (one.row == first.row) names += (names.empty() ? "" : ", ") + recommendation_name(one.wish);
  }
  fmt::print("\n{}: {}\n", names, figures_text(first.row));
  if (first.miss > 0)
    fmt::print("  in the way is the wish for {}: with the others met, {} is the best, {}\n",
               wish_text(first.wish, wishes), value_text(first.wish, first.row), miss_text(first.wish, first.miss));
  fmt::print("  {}\n", command);
}

}  // namespace

std::string misses_text(const AdviceRow& row, const Wishes& wishes) {
  std::string text;
  for (const Wish wish : all_wishes) {
    const double by = miss(row, wish, wishes);
    if (by > 0) text += (text.empty() ? "" : ", ") + miss_text(wish, by);
  }
  return text;
}

void print_question(const std::string& subject, std::span<const AdviceRow> rows, const Wishes& wishes) {
  const auto compiled = std::count_if(rows.begin(), rows.end(), [](const AdviceRow& row) { return row.compiled(); });
  fmt::print("{}: {} searched", printable(subject), session::counted(rows.size(), "choice"));
  const auto refused = rows.size() - static_cast<std::size_t>(compiled);
  if (refused > 0) fmt::print(", {} of which cannot be drawn", grouped(refused));
  fmt::print("\nwishes: ");
  for (const Wish wish : all_wishes) fmt::print("{}{}", wish == Wish::bits ? "" : ", ", wish_text(wish, wishes));
  fmt::print("\n");
}

void print_front(std::span<const AdviceRow> rows, const Wishes& wishes) {
  const std::vector<AdviceRow> front = with_colours(advice_front(rows), wishes);
  std::vector<AdviceRow> shown = nearest_choices(front, wishes, most_rows);
  const bool has_alu = std::any_of(shown.begin(), shown.end(), [&](const AdviceRow& row) {
    return row.point.alu_bits != shown.front().point.alu_bits;
  });
  fmt::print("\n{:>5}{:>5}{:>6}{:>8}{:>7}  {:<10}{:<13}{}{:>12}{:>10}{:>9}\n", "bits", "z", "frac.", "colour", "error",
             "strategy", "colouring", has_alu ? " ALU" : "", "clocks", "frames/s", "wrong");
  // In the order of the front.
  for (const AdviceRow& row : front) {
    if (std::find(shown.begin(), shown.end(), row) != shown.end()) print_row(row, has_alu, meets_all(row, wishes));
  }
  fmt::print("*: meets all wishes. ");
  if (shown.size() < front.size())
    fmt::print("The {} nearest to the wishes of {} that no other beats{}.\n", shown.size(), grouped(front.size()),
               colours_text(wishes));
  else
    fmt::print("No other choice beats these{}.\n", colours_text(wishes));
}

void print_advice(const Advice& advice, const Wishes& wishes) {
  const std::span<const Recommendation> all = advice.recommendations;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(i),
                    [&](const Recommendation& other) { return other.row == all[i].row; }))
      continue;
    print_recommendation(all.subspan(i), advice.commands[i], wishes);
  }
  if (!advice.nearest) return;
  fmt::print("\nnearest: {}\n  {}\n  {}\n", figures_text(*advice.nearest), misses_text(*advice.nearest, wishes),
             advice.nearest_command);
}

}  // namespace csgsim::studies
