#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "sim/observe/frame.h"
#include "sim/software/draw.h"
#include "sim/software/methods/method.h"
#include "sim/software/methods/rows.h"
#include "sim/software/rays/caster.h"
#include "sim/software/tree/tree.h"
#include "tests/oracle/pixel_oracle.h"

namespace csgsim::testing {

/// A way for software to draw a picture.
struct Way {
  software::Choice choice;
  software::Pruning pruning = software::Pruning::none;
  software::Shape shape = software::Shape::written;
};

/// As METHOD/COHERENCE PRUNING SHAPE.
std::string to_text(const Way& way);

/// Each method in each shape, with each coherence and each pruning that it takes.
const std::vector<Way>& all_ways();

/// The one with that name, as `choice_of` takes it.
Way way_of(const std::string& choice, software::Pruning pruning = software::Pruning::none,
           software::Shape shape = software::Shape::written);

/// A scene that is drawn in many ways. Keeps references.
class SoftwareScene {
 public:
  SoftwareScene(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view);

  [[nodiscard]] const software::RayCaster& rays() const { return rays_; }
  [[nodiscard]] const software::Tree& tree(software::Shape shape) const {
    return trees_[static_cast<std::size_t>(shape)];
  }
  /// Whether the way is one that has too few levels for its tree.
  [[nodiscard]] bool is_too_deep(const Way& way) const;
  [[nodiscard]] std::unique_ptr<software::Method> make(const Way& way, bool counts) const;
  [[nodiscard]] software::Picture draw(const Way& way, bool counts = false) const;
  /// The first pixel at which the way's picture is not that, in words; empty if there is none.
  [[nodiscard]] std::string fault_of(const Way& way, const std::vector<Seen>& expected) const;
  /// The same of so many of all ways, others with each number; those are left out that are too deep for their tree.
  [[nodiscard]] std::string fault_of_some(std::uint64_t number, std::size_t ways,
                                          const std::vector<Seen>& expected) const;

 private:
  const model::Tree& tree_;
  const facet::Geometry& geometry_;
  const view::View& view_;
  software::RayCaster rays_;
  std::array<software::Tree, 4> trees_;  ///< by shape
};

/// What some methods of software, others for each text, and those that draw facet by facet, draw of a model that is not
/// that picture; empty if all draw it. Where few cases are drawn, each fourth text is looked at.
std::string fault_of_software(const std::string& csg, const model::Tree& tree, const facet::Geometry& geometry,
                              const view::View& view, const observe::Frame& frame);

}  // namespace csgsim::testing
