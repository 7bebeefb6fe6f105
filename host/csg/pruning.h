#pragma once

namespace csgsim::csg {

/// Which prunings are done. None of them changes the picture; each is worth what it saves.
struct Pruning {
  bool space = true;       ///< boxes in model space that are disjoint
  bool picture = true;     ///< rectangles of pixels and ranges of depth that are disjoint
  bool separation = true;  ///< convex primitives that a plane separates
  bool halfspaces = true;  ///< half-spaces that hold all or nothing of the block, or never make the surface there
  bool hidden = true;      ///< primitives behind a finished nearer one
  bool sets = true;        ///< primitives that only intersections join are one convex solid (thesis 7.3.2)
  bool early_out = true;   ///< while it runs, what no pixel is left for, if the machine has a global OR
  bool near = true;        ///< the near plane where no pixel centre is before all fronts; else by corners alone
  bool pixels = false;  ///< with `halfspaces`: those that are a depth step from the deciding depth at every pixel, not
                        ///< only those that the decider at one corner exceeds at all four

  constexpr bool operator==(const Pruning&) const = default;

  /// The I-trees as they are.
  static constexpr Pruning none() { return {false, false, false, false, false, false, false, false, false}; }

  /// What the divider of the pixel-square machine does (hw/division): all by integers, boxes and corners of rectangles.
  static constexpr Pruning divider() { return {false, true, false, true, false, true, false, false, true}; }
};

}  // namespace csgsim::csg
