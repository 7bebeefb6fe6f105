#pragma once

#include "hw/division/surfaces.h"
#include "hw/division/writer.h"

namespace csgsim::division {

/// A surface as it is drawn into Z1 and merged into Z2: the convex-max of its fronts, or the concave-min of the backs
/// of a complemented one.
class Rendering {
 public:
  Rendering(Datapath& path, const Surface& surface);

  /// Whether no pixel can have one; then nothing may be written.
  [[nodiscard]] bool nothing() const { return nothing_; }

  /// Z1 := the surface, and its colour beside it if there is a field for it. Leaves E 1 where there is one.
  void write_surface(Writer& out, const Rectangle& square) const;

  /// Leaves E and the mask 1 where E is 1 and Z1 is nearer than Z2.
  void write_depth_test(Writer& out) const;

  /// Z1 and its colour to Z2 where E is 1. The mask has to be E.
  void write_merge(Writer& out) const;

 private:
  /// What Z1 can come from: a half-space, or depth 0.
  struct Facet {
    bool at_zero = false;
    std::uint32_t primitive = 0;
    std::uint32_t colour = 0;
    Plane plane;
    std::int64_t low = 0;   ///< the least depth step over the surface's pixels
    std::int64_t high = 0;  ///< the greatest
  };

  [[nodiscard]] Facet facet_of(const Tested& tested) const;
  [[nodiscard]] bool fits(const Facet& facet) const;
  [[nodiscard]] isa::Origin shading(const Facet& facet) const;
  void write_start(Writer& out) const;
  void write_extreme(Writer& out) const;
  void write_extreme_with_colours(Writer& out) const;
  void write_replacement(Writer& out, const Facet& facet, bool equals_too) const;
  void write_candidate_colour(Writer& out, const Facet& facet) const;
  void write_near_test(Writer& out) const;
  void write_colours(Writer& out) const;

  const ModelHeader& model_;
  const Surface& surface_;
  bool complemented_;
  bool nothing_ = false;
  std::vector<Facet> facets_;   ///< of the side that is seen, in order; the first may be at depth 0
  std::vector<Tested> others_;  ///< of the other side
  std::size_t start_ = 0;       ///< the facet that Z1 starts from; their number for the end of the depth range
};

}  // namespace csgsim::division
