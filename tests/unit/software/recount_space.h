#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim/software/space/directory.h"
#include "tests/unit/software/recount_steps.h"

namespace csgsim::testing {

/// What building a directory takes, counted again by its rule: facets are held against cells by separating axes.
/// Of `made`, walls of a k-d tree and boxes are taken. Throws logic_error where its cells are not those of the rule.
software::SpaceBuilt recounted_space(const std::string& name, const software::FacetShapes& shapes,
                                     std::uint32_t bucket_size, const software::Directory& made);

/// What rays take to go through a directory, counted again from its cells.
class WalkRecount {
 public:
  /// Keeps references.
  WalkRecount(const std::string& name, const software::FacetShapes& shapes, std::uint32_t bucket_size,
              const software::Directory& made);

  /// Of a ray that looks into that many cells; `is_stopped`: it had enough in the last one.
  [[nodiscard]] Operations along(const software::SpaceRay& ray, std::size_t cells, bool is_stopped) const;

 private:
  struct Walk;

  [[nodiscard]] std::uint64_t buckets(const software::SpacePart& cell) const;
  void go_by_halves(Walk& walk, const software::SpacePart& part, double begin, double end) const;
  void go_by_points(Walk& walk, double begin, double end) const;
  void go_by_boxes(Walk& walk) const;

  std::string name_;
  facet::Box box_;
  std::uint32_t bucket_size_;
  std::unique_ptr<software::Directory> halved_;  ///< has the parts of EXCELL's cells
  std::vector<software::SpacePart> parts_;
  std::vector<software::SpaceBox> boxes_;
  bool is_empty_;
};

}  // namespace csgsim::testing
