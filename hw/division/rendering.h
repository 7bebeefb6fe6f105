#pragma once

#include "hw/division/surfaces.h"
#include "hw/division/writer.h"

namespace csgsim::division {

/// A surface as drawn into Z1 and merged into Z2: the convex-max of its fronts, or the concave-min of the backs of a
/// complemented one.
class Rendering {
 public:
  Rendering(Datapath& path, const Surface& surface);

  /// Whether no pixel can show the surface; then nothing may be written.
  [[nodiscard]] bool is_empty() const { return is_empty_; }

  /// Z1 := the surface, and its colour if there is a field for it. Leaves E = 1 where the surface is.
  void write_surface(Writer& out, const Rectangle& square) const;

  /// Leaves E and the mask 1 where E is 1 and Z1 is nearer than Z2.
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

  [[nodiscard]] Facet facet_of(const Tested& tested) const;
  [[nodiscard]] bool fits(const Facet& facet) const;
  [[nodiscard]] isa::Origin shading(const Facet& facet) const;
  void write_start(Writer& out) const;
  void write_extreme(Writer& out) const;
  void write_extreme_with_colours(Writer& out) const;
  void write_replacement(Writer& out, const Facet& facet, bool replace_equal) const;
  void write_candidate_colour(Writer& out, const Facet& facet) const;
  void write_near_test(Writer& out) const;
  void write_colours(Writer& out) const;

  const ModelHeader& model_;
  const Surface& surface_;
  bool complemented_;
  bool is_empty_ = false;
  std::vector<Facet> facets_;   ///< facets of the visible side, in order; the first may be at depth 0
  std::vector<Tested> others_;  ///< facets of the other side
  std::size_t start_ = 0;       ///< facet with which Z1 starts; the number of facets for the end of the depth range
};

}  // namespace csgsim::division
