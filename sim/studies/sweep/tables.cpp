#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "hw/base/text.h"
#include "sim/observe/bound.h"
#include "sim/session/options/numbers.h"
#include "sim/studies/design/meter.h"
#include "sim/studies/folder.h"
#include "sim/studies/groups.h"
#include "sim/studies/sweep/show.h"

namespace csgsim::studies {

namespace {

using Group = std::vector<SweepRow>;

/// Orders rows by classification bits, then clocks.
bool takes_fewer_bits(const SweepRow& a, const SweepRow& b) {
  return std::tie(a.classification_bits, a.clocks) < std::tie(b.classification_bits, b.clocks);
}

bool takes_fewer_clocks(const SweepRow& a, const SweepRow& b) {
  return std::tie(a.clocks, a.classification_bits) < std::tie(b.clocks, b.classification_bits);
}

std::string used(const SweepRow& row) {
  const bool is_chosen = row.strategy_used != row.point.strategy || row.colouring_used != row.point.colouring;
  return is_chosen ? fmt::format("  ({}, {})", row.strategy_used, row.colouring_used) : "";
}

void print_points(std::span<const SweepRow> rows) {
  const PointNames names(rows);
  std::size_t width = 12;
  for (const SweepRow& row : rows) width = std::max(width, names.name(row.point).size() + 2);
  fmt::print("\n{:<{}}{:>14}{:>10}{:>11}{:>10}{:>12}{:>13}{:>13}{:>13}{:>13}  {}\n", "", width, "clocks", "frames/s",
             "with host", "rendered", "classified", "depth tests", "class. bits", "total bits", "transistors",
             "picture");
  for (const SweepRow& row : rows) {
    if (!row.is_compiled()) {
      fmt::print("{:<{}}  {}\n", names.name(row.point), width, row.reason);
      continue;
    }
    fmt::print("{:<{}}{:>14}{:>10}{:>11}{:>10}{:>12}{:>13}{:>13}{:>13}{:>13}  {}{}\n", names.name(row.point), width,
               grouped(row.clocks), observe::rate_text(row.frames_per_second),
               observe::rate_text(row.hosted_frames_per_second), grouped(row.rendered), grouped(row.classified),
               grouped(row.depth_tests), row.classification_bits, row.used_bits,
               row.pixel_transistors ? grouped(*row.pixel_transistors) : "-",
               row.picture.empty() ? "not drawn" : row.picture, used(row));
  }
  if (std::any_of(rows.begin(), rows.end(), [](const SweepRow& row) { return row.pixel_transistors.has_value(); }))
    fmt::print("Transistor counts are estimates (docs/hardware.md) of a pixel with the total bits.\n");
}

/// The rows of strategy bits in the form of the thesis's table; empty if there are none.
std::string table_6_1(const Group& rows) {
  constexpr int label_width = 68;
  std::string bits = fmt::format("  {:<{}}", "number of available bits for the stack", label_width);
  std::string rendered = fmt::format("  {:<{}}", "number of scan-conversions of primitives", label_width);
  std::string tests = fmt::format("  {:<{}}", "number of depth-buffer tests", label_width);
  std::string classified =
      fmt::format("  {:<{}}", "number of scan-conversions of primitives in active trees, to compare", label_width);
  bool any = false;
  for (const SweepRow& row : rows) {
    if (row.point.stack_bits == 0) continue;
    any = true;
    const auto cell = [&](std::uint64_t count) {
      return fmt::format("{:>8}", row.is_compiled() ? grouped(count) : "-");
    };
    bits += fmt::format("{:>8}", row.point.stack_bits);
    rendered += cell(row.rendered);
    tests += cell(row.depth_tests);
    classified += cell(row.classified);
  }
  return any ? bits + "\n" + rendered + "\n" + tests + "\n" + classified + "\n" : "";
}

/// Texts about groups of rows, each with the conditions under which it holds, in the order of the groups.
template <class Text>
std::vector<std::pair<std::string, std::string>> shared(std::span<const SweepRow> rows, Text text_of) {
  const PointNames names(rows);
  std::vector<std::pair<std::string, std::string>> texts;
  for (const Group& group : group_by_conditions(rows)) {
    const std::string text = text_of(group);
    if (text.empty()) continue;
    const std::string conditions = names.conditions(group.front().point);
    const auto same = std::find_if(texts.begin(), texts.end(), [&](const auto& one) { return one.first == text; });
    if (same == texts.end()) {
      texts.emplace_back(text, conditions);
    } else {
      same->second += "; " + conditions;
    }
  }
  return texts;
}

std::string share(std::uint64_t more, std::uint64_t than) {
  return fmt::format("{:+.1f} %", 100.0 * (static_cast<double>(more) / static_cast<double>(than) - 1.0));
}

std::string classification(const SweepRow& row) {
  return session::count_text(row.classification_bits, "bit") + " for the classification";
}

/// Summary of one group of strategies.
std::string conclusion(const Group& group) {
  Group by_bits;
  for (const SweepRow& row : group) {
    if (row.is_compiled()) by_bits.push_back(row);
  }
  if (by_bits.empty()) return "  nothing fits\n";
  std::sort(by_bits.begin(), by_bits.end(), takes_fewer_bits);
  const SweepRow& smallest = by_bits.front();
  const SweepRow& fastest = *std::min_element(by_bits.begin(), by_bits.end(), takes_fewer_clocks);
  const SweepRow& slowest = *std::max_element(by_bits.begin(), by_bits.end(), takes_fewer_clocks);
  std::string text = fmt::format("  fewest clocks: {}, {}, with {}; most: {}, {} ({})\n", strategy_name(fastest.point),
                                 grouped(fastest.clocks), classification(fastest), strategy_name(slowest.point),
                                 grouped(slowest.clocks), share(slowest.clocks, fastest.clocks));
  text += fmt::format("  fewest bits:   {}, {}, {} in total, {} clocks ({})\n", strategy_name(smallest.point),
                      classification(smallest), smallest.used_bits, grouped(smallest.clocks),
                      share(smallest.clocks, fastest.clocks));
  std::string steps;
  std::uint64_t best = ~std::uint64_t{0};
  for (const SweepRow& row : by_bits) {
    if (row.clocks >= best) continue;
    best = row.clocks;
    steps +=
        fmt::format("{}{} {} clocks ({})", steps.empty() ? "" : ", ",
                    session::count_text(row.classification_bits, "bit"), grouped(row.clocks), strategy_name(row.point));
  }
  return text + "  clocks by bits: " + steps + "\n";
}

void print_failures(std::span<const SweepRow> rows) {
  const auto failed = std::count_if(rows.begin(), rows.end(), [](const SweepRow& row) { return !row.is_compiled(); });
  if (failed > 0)
    fmt::print("  {} of {} points cannot be compiled; see the table for the reasons\n", failed, rows.size());
}

bool is_one_reason(std::span<const SweepRow> rows) {
  return std::ranges::all_of(rows, [&](const SweepRow& row) { return row.reason == rows.front().reason; });
}

}  // namespace

std::vector<std::vector<SweepRow>> group_by_conditions(std::span<const SweepRow> rows) {
  const auto conditions_of = [](const SweepRow& row) {
    DesignPoint point = row.point;
    point.strategy.clear();
    point.stack_bits = 0;
    return point;
  };
  std::vector<std::vector<SweepRow>> groups;
  for (const auto& [conditions, group] : grouped_by(rows, conditions_of)) {
    std::vector<SweepRow>& copied = groups.emplace_back();
    for (const SweepRow* const row : group) copied.push_back(*row);
  }
  return groups;
}

std::vector<WrongPicture> wrong_pictures(std::span<const SweepRow> rows) {
  // The half-spaces are part of the key because machines differ in which curved surfaces they draw without facets, and
  // such pictures may differ.
  const auto picture_of = [](const SweepRow& row) {
    return std::tuple(row.point.model, row.point.width, row.point.height, row.point.z_bits, row.halfspaces);
  };
  std::map<decltype(picture_of(rows.front())), const SweepRow*> references;
  std::vector<WrongPicture> wrong;
  for (const SweepRow& row : rows) {
    if (row.picture.empty()) continue;
    if (row.picture == overflow) {
      wrong.push_back({row.point, std::nullopt});
      continue;
    }
    const SweepRow& reference = *references.try_emplace(picture_of(row), &row).first->second;
    if (reference.picture != row.picture) wrong.push_back({row.point, reference.point});
  }
  return wrong;
}

void print_sweep(std::span<const SweepRow> rows) {
  // Rows without a Program have no data of the model.
  const auto compiled = std::find_if(rows.begin(), rows.end(), [](const SweepRow& row) { return row.is_compiled(); });
  if (compiled == rows.end() && is_one_reason(rows)) {
    fmt::print("\n{}\n", with_model_name(rows.front().point.model, rows.front().reason));
    return;
  }
  const SweepRow& facts = compiled == rows.end() ? rows.front() : *compiled;
  fmt::print("\n{}: {}, {}, {} x {} pixels\n", facts.point.model, session::count_text(facts.primitives, "primitive"),
             session::count_text(facts.halfspaces, "half-space"), facts.point.width, facts.point.height);
  print_points(rows);
  for (const auto& [table, conditions] : shared(rows, table_6_1)) {
    fmt::print("\nTable 6.1: rendering versus memory, {} primitive solids{}{}\n{}", grouped(facts.primitives),
               conditions.empty() ? "" : "; ", conditions, table);
  }
  for (const auto& [text, conditions] : shared(rows, conclusion))
    fmt::print("\nConclusions{}{}:\n{}", conditions.empty() ? "" : "; ", conditions, text);
  print_failures(rows);
}

}  // namespace csgsim::studies
