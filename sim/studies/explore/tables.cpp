#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "hw/base/text.h"
#include "hw/machines/names.h"
#include "sim/session/options/numbers.h"
#include "sim/studies/explore/show.h"

namespace csgsim::studies {

namespace {

/// Of a front that are printed; files have all.
constexpr std::size_t most_printed = 40;

/// From here on no fraction is shown.
constexpr double least_rounded = 10'000;
constexpr double most_grouped = 1e15;

using Texts = std::vector<std::pair<std::string, std::string>>;

Texts texts_of(const ExplorePoint& point) {
  Texts texts;
  for (const std::string& change : machines::changes_of(point.machine)) {
    const std::size_t equals = change.find('=');
    texts.emplace_back(change.substr(0, equals), equals == change.npos ? "" : change.substr(equals + 1));
  }
  texts.emplace_back("size", fmt::format("{}x{}", point.width, point.height));
  texts.emplace_back("memory-bits", point.memory_bits ? std::to_string(*point.memory_bits) : "");
  texts.emplace_back("z-bits", std::to_string(point.z_bits));
  texts.emplace_back("fraction-bits", std::to_string(point.fraction_bits));
  texts.emplace_back("colour-bits", std::to_string(point.colour_bits));
  texts.emplace_back("strategy", point.strategy);
  texts.emplace_back("stack-bits", point.stack_bits == 0 ? "" : std::to_string(point.stack_bits));
  texts.emplace_back("colouring", point.colouring);
  texts.emplace_back("curves", point.curves);
  texts.emplace_back("pruning", point.pruning);
  return texts;
}

std::string value_text(double value) {
  const bool is_shown_whole = value >= least_rounded || value == std::floor(value);
  if (value >= 0 && value < most_grouped && is_shown_whole)
    return grouped(static_cast<std::uint64_t>(std::llround(value)));
  return fmt::format("{:.4g}", value);
}

/// Cells of a table, with a line a row; columns are as wide as they have to be.
void print_cells(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths(lines.front().size());
  for (const std::vector<std::string>& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  for (const std::vector<std::string>& line : lines) {
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i) text += fmt::format("  {:>{}}", line[i], widths[i]);
    fmt::print("{}\n", text);
  }
}

/// The candidates of the front, by the first axis; of those that are the same on all axes the first.
std::vector<std::size_t> listed_front(const ExploreGroup& group) {
  std::vector<std::size_t> front;
  std::set<Values> known;
  for (std::size_t i = 0; i < group.values.size(); ++i) {
    if (group.front[i] && known.insert(group.values[i]).second) front.push_back(i);
  }
  std::ranges::stable_sort(front, {}, [&](std::size_t one) -> const Values& { return group.values[one]; });
  return front;
}

void print_front(std::span<const ExploreRow> rows, const DesignNames& names, const ExploreGroup& group) {
  std::vector<std::vector<std::string>> lines(1, names.keys());
  for (const ExploreAxis& axis : group.axes) lines[0].emplace_back(axis.title);
  const std::vector<std::size_t> front = listed_front(group);
  for (const std::size_t one : front) {
    if (lines.size() > most_printed) break;
    lines.push_back(names.values(rows[group.rows[one]].point));
    for (const double value : group.values[one]) lines.back().push_back(value_text(value));
    if (one == group.knee) lines.back().emplace_back("knee");
  }
  lines[0].emplace_back("");
  for (std::vector<std::string>& line : lines) line.resize(lines[0].size());
  print_cells(lines);
  if (front.size() > most_printed) fmt::print("  and {} more, in explore.json\n", grouped(front.size() - most_printed));
}

std::string group_text(const ExploreGroup& group) {
  const auto on_front = static_cast<std::uint64_t>(std::ranges::count(group.front, true));
  std::string text =
      fmt::format("{}: {} on the front of {}", group.model.empty() ? "All models" : group.model, grouped(on_front),
                  session::counted(group.values.size() + group.refused + group.unpriced, "design"));
  if (group.refused > 0) text += fmt::format("; {} cannot be drawn", grouped(group.refused));
  if (group.unpriced > 0) text += fmt::format("; {} without a price on an axis left out", grouped(group.unpriced));
  return text;
}

/// Each reason once, with the first design that it refuses.
void print_refused(std::span<const ExploreRow> rows, const DesignNames& names, const std::string& model) {
  std::vector<std::pair<const ExploreRow*, std::uint64_t>> reasons;  // the first, and how many more
  for (const ExploreRow& row : rows) {
    if (row.drawn() || row.point.model != model) continue;
    const auto same =
        std::ranges::find_if(reasons, [&](const auto& known) { return known.first->reason == row.reason; });
    if (same == reasons.end()) {
      reasons.emplace_back(&row, 0);
    } else {
      ++same->second;
    }
  }
  for (const auto& [row, more] : reasons) {
    const std::string others =
        more > 0 ? fmt::format(", as {} {}", more == 1 ? "does" : "do", session::counted(more, "other design")) : "";
    fmt::print("  {} cannot be drawn{}: {}\n", names.text(row->point), others, row->reason);
  }
}

void print_knee(std::span<const ExploreRow> rows, const DesignNames& names, const ShownGroup& shown) {
  const ExploreGroup& group = shown.group;
  std::string values;
  for (std::size_t axis = 0; axis < group.axes.size(); ++axis)
    values += fmt::format("; {} {}", group.axes[axis].title, value_text(group.values[*group.knee][axis]));
  fmt::print("knee: {}{}\n", names.text(rows[group.rows[*group.knee]].point), values);
  for (const std::string& command : shown.commands) fmt::print("  {}\n", command);
}

}  // namespace

DesignNames::DesignNames(std::span<const ExploreRow> rows) {
  std::map<std::string, std::set<std::string>> values;
  std::vector<std::string> order;
  for (const ExploreRow& row : rows) {
    for (auto& [key, value] : texts_of(row.point)) {
      if (!values.contains(key)) order.push_back(key);
      values[key].insert(value);
    }
  }
  std::ranges::copy_if(order, std::back_inserter(keys_),
                       [&](const std::string& key) { return values[key].size() > 1; });
}

std::vector<std::string> DesignNames::values(const ExplorePoint& point) const {
  const Texts texts = texts_of(point);
  std::vector<std::string> values;
  for (const std::string& key : keys_) {
    const auto found = std::ranges::find(texts, key, &Texts::value_type::first);
    values.push_back(found == texts.end() ? "" : found->second);
  }
  return values;
}

std::string DesignNames::text(const ExplorePoint& point) const {
  const std::vector<std::string> of_keys = values(point);
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    if (!of_keys[i].empty()) parts.push_back(keys_[i] + "=" + of_keys[i]);
  }
  return parts.empty() ? point.machine : fmt::format("{}", fmt::join(parts, ", "));
}

void print_explored(std::span<const ExploreRow> rows, std::span<const ShownGroup> groups) {
  const DesignNames names(rows);
  bool is_first = true;
  for (const ShownGroup& shown : groups) {
    fmt::print("{}{}\n", is_first ? "" : "\n", group_text(shown.group));
    is_first = false;
    if (!shown.group.model.empty()) print_refused(rows, names, shown.group.model);
    if (!shown.group.knee) continue;
    print_front(rows, names, shown.group);
    print_knee(rows, names, shown);
  }
}

}  // namespace csgsim::studies
