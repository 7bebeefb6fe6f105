#pragma once

#include "hw/division/surfaces.h"
#include "hw/division/writer.h"

namespace csgsim::division {

/// A surface as drawn into Z1 and merged into Z2: the convex-max of the primitives' fronts or, if they are
/// complemented, the concave-min of their backs.
class Rendering {
 public:
  Rendering(Datapath& path, const Surface& surface);

  /// Whether no pixel can show the surface; in that case no instruction may be written.
  [[nodiscard]] bool is_empty() const { return is_empty_; }

  /// Sets Z1 to the surface's depth, and the candidate colour if there is a field for it. Leaves E = 1 at the surface's
  /// pixels.
  void write_surface(Writer& out, const Rectangle& square) const;

  /// Clears E where Z1 is not nearer than Z2, and copies E to the mask.
  void write_depth_test(Writer& out) const;

  /// Copies Z1 and its colour to Z2 where E is 1. The mask must equal E.
  void write_merge(Writer& out) const;

 private:
  /// Possible source of Z1: a half-space, or depth 0.
  struct Facet {
    bool at_zero = false;
    std::uint32_t primitive = 0;
    std::uint32_t colour = 0;
    Plane plane;
    std::int64_t low = 0;   ///< minimum depth step over the surface's pixels
    std::int64_t high = 0;  ///< maximum depth step
  };

  [[nodiscard]] Facet facet_of(const TestedHalfspace& tested) const;
  [[nodiscard]] bool fits(const Facet& facet) const;
  [[nodiscard]] isa::Origin shading(const Facet& facet) const;
  void write_start(Writer& out) const;
  void write_extreme(Writer& out) const;
  void write_extreme_with_colours(Writer& out) const;
  /// Writes the replacement of Z1, and of its colour, by the facet where it is more extreme, or equal if
  /// `replace_equal`.
  void write_replacement(Writer& out, const Facet& facet, bool replace_equal) const;
  void write_candidate_colour(Writer& out, const Facet& facet) const;
  void write_near_test(Writer& out) const;
  void write_colours(Writer& out) const;

  const ModelHeader& model_;
  const Surface& surface_;
  bool complemented_;
  bool is_empty_ = false;
  std::vector<Facet> facets_;            ///< facets of the visible side, in order; the first may be at depth 0
  std::vector<TestedHalfspace> others_;  ///< facets of the other side
  /// Facet with which Z1 starts; the number of facets if it starts with the end of the depth range.
  std::size_t start_ = 0;
};

}  // namespace csgsim::division
