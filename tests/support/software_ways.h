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

/// Software rendering method with its options.
struct MethodVariant {
  software::Choice choice;
  software::Pruning pruning = software::Pruning::none;
  software::Shape shape = software::Shape::written;
};

/// Formatted as METHOD/COHERENCE PRUNING SHAPE.
std::string to_text(const MethodVariant& way);

/// Each method in each shape, with every coherence and pruning that it supports.
const std::vector<MethodVariant>& all_variants();

/// Looks up a method by the name that `choice_of` accepts.
MethodVariant variant_named(const std::string& choice, software::Pruning pruning = software::Pruning::none,
                            software::Shape shape = software::Shape::written);

/// Scene to be drawn with many methods. Keeps references.
class SoftwareScene {
 public:
  SoftwareScene(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view);

  [[nodiscard]] const software::RayCaster& rays() const { return rays_; }
  [[nodiscard]] const software::Tree& tree(software::Shape shape) const {
    return trees_[static_cast<std::size_t>(shape)];
  }
  /// Whether the tree is deeper than the method supports.
  [[nodiscard]] bool is_too_deep(const MethodVariant& way) const;
  [[nodiscard]] std::unique_ptr<software::Method> make(const MethodVariant& way, bool counts) const;
  [[nodiscard]] software::Picture draw(const MethodVariant& way, bool counts = false) const;
  /// Describes the first pixel at which the method's picture differs from the expected one; empty if none does.
  [[nodiscard]] std::string describe_mismatch(const MethodVariant& way, const std::vector<Seen>& expected) const;
  /// describe_mismatch() for `ways` consecutive elements of all_variants() from element `number` * `ways` on,
  /// cyclically. Methods that do not support the tree's depth are omitted.
  [[nodiscard]] std::string describe_some_mismatch(std::uint64_t number, std::size_t ways,
                                                   const std::vector<Seen>& expected) const;

 private:
  const model::Tree& tree_;
  const facet::Geometry& geometry_;
  const view::View& view_;
  software::RayCaster rays_;
  std::array<software::Tree, 4> trees_;  ///< indexed by shape
};

/// Describes a difference between the given picture and those of some software methods, which depend on the text, and
/// of the methods that draw facet by facet; empty if all agree. With a reduced number of cases only every fourth text
/// is checked.
std::string describe_software_mismatch(const std::string& csg, const model::Tree& tree, const facet::Geometry& geometry,
                                       const view::View& view, const observe::Frame& frame);

}  // namespace csgsim::testing
