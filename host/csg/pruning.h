// The prunings of CSG trees that can be switched on and off.
// Used by host/emit and sim/session.
#pragma once

namespace csgsim::csg {

/// The enabled prunings. None of them changes the picture.
struct Pruning {
  bool space = true;       ///< disjoint boxes in model space
  bool picture = true;     ///< disjoint rectangles of pixels and ranges of depth
  bool separation = true;  ///< convex primitives that a plane separates
  bool halfspaces = true;  ///< half-spaces that contain all or nothing of the block, or never form the surface there
  bool hidden = true;      ///< primitives behind a finished nearer one
  bool sets = true;        ///< primitives that only intersections join become one convex solid (thesis 7.3.2)
  bool early_out = true;   ///< at run time: skips instructions that no pixel needs, if the machine has a global OR
  bool near = true;        ///< drops the near plane if no pixel centre is in front of all fronts; without it, tests
                           ///< only corners
  bool pixels = false;  ///< with `halfspaces`: drops half-spaces that are at least a depth step behind the extreme at
                        ///< every pixel; without it, tests only the corners of the rectangle

  constexpr bool operator==(const Pruning&) const = default;

  /// Leaves I-trees unchanged.
  static constexpr Pruning none() { return {false, false, false, false, false, false, false, false, false}; }

  /// The prunings of the pixel-square machine's divider (hw/division), which uses integers, boxes and corners of
  /// rectangles.
  static constexpr Pruning divider() { return {false, true, false, true, false, true, false, false, true}; }
};

}  // namespace csgsim::csg
