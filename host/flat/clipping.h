#pragma once

#include <polyclipping/clipper.hpp>
#include <span>

#include "host/flat/area.h"
#include "hw/base/work.h"

namespace csgsim::flat {

/// Units of Clipper's integers in a model unit; OpenSCAD's, and so are its ways of rounding here: coordinates lose what
/// is smaller, towards 0.
inline constexpr double clipper_scale = 65'536;

/// Coordinates beyond this, in model units, are refused: sums of two of them must stay within what Clipper takes.
inline constexpr double largest_coordinate = 1e12;

/// Throws InputError for coordinates that are not finite or too large.
ClipperLib::Path path_of(const Outline& outline);
ClipperLib::Paths paths_of(const Area& area);

/// Closed paths that are to be combined: the first that are added with all others.
class Clipping {
 public:
  void add(ClipperLib::Paths paths);

  /// Fills `result`. Throws InputError where Clipper gives up, and WorkError past the limit on work, before it begins.
  void execute(ClipperLib::ClipType operation, ClipperLib::PolyFillType rule, ClipperLib::PolyTree& result,
               const Work& work = {});

 private:
  ClipperLib::Clipper clipper_;
  ClipperLib::Paths paths_;
  ClipperLib::PolyType type_ = ClipperLib::ptSubject;  ///< of those that are added next
};

/// The area of a tree as Clipper makes it, without corners that are on the line of their neighbours within 1.4 units.
Area area_of(const ClipperLib::PolyTree& tree);

/// The first of the areas combined with all others at once, each of which is what its outlines run around more often
/// one way than the other.
Area combined(std::span<const Area> areas, ClipperLib::ClipType operation, const Work& work = {});

/// What lies within an odd number of the paths.
Area even_odd(const ClipperLib::Paths& paths, const Work& work = {});

/// What the paths run around more often one way than the other.
Area non_zero(const ClipperLib::Paths& paths, const Work& work = {});

}  // namespace csgsim::flat
