#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/design/front.h"

namespace csgsim::studies {

/// What tells the designs of some rows apart: the figures and options that vary among them.
class DesignNames {
 public:
  explicit DesignNames(std::span<const ExploreRow> rows);

  /// As in --vary; `machine` and `model` are none of them.
  [[nodiscard]] const std::vector<std::string>& keys() const { return keys_; }
  /// Of each key; empty where the design does not say it.
  [[nodiscard]] std::vector<std::string> values(const DesignPoint& point) const;
  /// As `alu.bits=4, strategy=list`.
  [[nodiscard]] std::string text(const DesignPoint& point) const;

 private:
  std::vector<std::string> keys_;
};

/// A group with the commands that draw its knee, one a model.
struct ShownGroup {
  ExploreGroup group;
  std::vector<std::string> commands;
};

/// On standard output, of each group: how many designs there are, the front, and the knee.
void print_explored(std::span<const ExploreRow> rows, std::span<const ShownGroup> groups);

/// explore.json: all points, of each whether it is on its model's front and its knee; and the groups.
std::string explore_json(const std::string& title, std::span<const ExploreRow> rows,
                         std::span<const ShownGroup> groups);

/// Of each group of two axes or more the first of them against each other one: all designs, those of the front, the
/// front of these two axes alone, and the knee.
std::vector<plots::Plot> plots_of_explore(std::span<const ShownGroup> groups);

}  // namespace csgsim::studies
