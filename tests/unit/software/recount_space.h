#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim/software/space/directory.h"
#include "tests/unit/software/recount_steps.h"

namespace csgsim::testing {

/// Recounts the costs of building a directory by its rule: facets are tested against cells by separating axes. Walls of
/// a k-d tree and boxes are taken from `made`. Throws logic_error if its cells differ from the rule's.
software::SpaceBuilt recounted_space(const std::string& name, const software::FacetShapes& shapes,
                                     std::uint32_t bucket_size, const software::Directory& made);

/// Recounts the costs of rays through a directory from its cells.
class WalkRecount {
 public:
  /// Keeps references.
  WalkRecount(const std::string& name, const software::FacetShapes& shapes, std::uint32_t bucket_size,
              const software::Directory& made);

  /// Costs of a ray that visits `cells` cells; with `is_stopped` the visitor stopped in the last one.
  [[nodiscard]] Operations along(const software::SpaceRay& ray, std::size_t cells, bool is_stopped) const;

 private:
  struct Walk;
  /// A cell of a lattice as a range of its numbers.
  struct Block {
    std::array<std::int64_t, 3> first;
    std::array<std::int64_t, 3> end;
    std::uint64_t facets;

    [[nodiscard]] bool holds(const std::array<std::int64_t, 3>& at) const {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (at[axis] < first[axis] || at[axis] >= end[axis]) return false;
      }
      return true;
    }
  };

  /// Lists of a bucket with `facets` facets.
  [[nodiscard]] std::uint64_t lists(std::uint64_t facets) const { return (facets + bucket_size_ - 1) / bucket_size_; }
  [[nodiscard]] std::int64_t cells() const { return name_ == "excell" ? 32 : 128; }
  /// Number of the cell at a place along an axis, as a fraction.
  [[nodiscard]] double number(int axis, double place) const {
    return (place - box_.low[axis]) / (box_.high[axis] - box_.low[axis]) * static_cast<double>(cells());
  }
  void go_by_halves(Walk& walk, const software::SpacePart& part, double begin, double end) const;
  void go_by_points(Walk& walk, double begin, double end) const;
  void go_by_boxes(Walk& walk) const;

  std::string name_;
  facet::Box box_;
  std::uint32_t bucket_size_;
  std::unique_ptr<software::Directory> halved_;  ///< has the parts of EXCELL's cells
  std::vector<software::SpacePart> parts_;
  std::vector<software::SpaceBox> boxes_;
  std::vector<Block> blocks_;  ///< cells of directories that are walked from query point to query point
  bool is_empty_;
};

}  // namespace csgsim::testing
