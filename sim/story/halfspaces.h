// Finds the half-space or quadric behind an instruction.
// Used by sim/story and sim/session.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "host/csg/convex_sets.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "hw/isa/program.h"

namespace csgsim::story {

/// A half-space of a primitive in the model: normal . p <= distance.
struct ModelHalfspace {
  std::uint32_t primitive = 0;
  std::size_t index = 0;  ///< among those of the primitive, from 0
  std::size_t count = 0;  ///< number of half-spaces of the primitive
  glm::dvec3 normal{0};   ///< unit vector that points out of the solid
  double distance = 0;    ///< from the origin along the normal, in model units
};

/// A quadric that bounds a primitive in the model.
struct ModelQuadric {
  std::uint32_t primitive = 0;
  std::size_t index = 0;  ///< among those of the primitive, from 0
  std::size_t count = 0;  ///< number of quadrics of the primitive
  facet::QuadricKind kind{};
  glm::dvec3 origin{0};  ///< centre, a point of the axis, or apex; in model units
  glm::dvec3 axis{0};    ///< unit vector of cylinders and cones
};

/// Finds the half-space whose plane an instruction streams, by the plane's coefficients: a Program does not record it.
class HalfspaceFinder {
 public:
  /// Keeps a reference to the geometry.
  HalfspaceFinder(const model::Tree& tree, const facet::Geometry& geometry, view::View view);

  [[nodiscard]] const view::View& view() const { return view_; }

  /// A half-space of the primitive whose surface is drawn or compared, or of a primitive that forms one convex solid
  /// with it. Nothing if the instruction has no linear expression, or if the expression does not stem from a half-space
  /// at the pixel's centre: a rectangle of pixels, another sample, a model in a mirror.
  [[nodiscard]] std::optional<ModelHalfspace> find(const isa::Instruction& instruction,
                                                   const isa::Region& region) const;

  /// The quadric whose discriminant the two instructions stream; otherwise like the half-space.
  [[nodiscard]] std::optional<ModelQuadric> find(const isa::Instruction& squares, const isa::Instruction& linear,
                                                 const isa::Region& region) const;

  /// Primitives that may be drawn as one solid with this one, including itself, in tree order.
  [[nodiscard]] const csg::ConvexSet& set_of(std::uint32_t primitive) const { return sets_[set_of_[primitive]]; }

  /// Rectangle of pixels that contains the primitive.
  [[nodiscard]] const view::PixelRect& rectangle_of(std::uint32_t primitive) const {
    return view_.extents[primitive].pixels;
  }

 private:
  template <class FindIn>
  [[nodiscard]] auto find_of(const isa::Origin& origin, const FindIn& find_in) const;

  [[nodiscard]] std::optional<ModelHalfspace> find_in(std::uint32_t primitive, const isa::Instruction& instruction,
                                                      const isa::Region& region) const;

  [[nodiscard]] std::optional<ModelQuadric> find_in(std::uint32_t primitive, const isa::Instruction& squares,
                                                    const isa::Instruction& linear, const isa::Region& region) const;

  const facet::Geometry& geometry_;
  view::View view_;
  std::vector<csg::ConvexSet> sets_;
  std::vector<std::size_t> set_of_;  ///< one per primitive
};

}  // namespace csgsim::story
