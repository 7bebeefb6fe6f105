// Conversions to and from Clipper, and its Boolean operations.
// Used throughout host/flat.
#pragma once

#include <polyclipping/clipper.hpp>
#include <span>

#include "host/flat/area.h"
#include "hw/base/work.h"

namespace csgsim::flat {

/// Number of Clipper's integer units in a model unit. As in OpenSCAD, coordinates are truncated towards 0 to this grid.
inline constexpr double clipper_scale = 65'536;

/// Limit of coordinates, in model units, because the sum of two of them must stay in Clipper's range.
inline constexpr double largest_coordinate = 1e12;

/// Both functions throw InputError for coordinates that are not finite or too large.
ClipperLib::Path to_path(const Outline& outline);
ClipperLib::Paths to_paths(const Area& area);

/// Closed paths to be combined: the first set added is the subject, all others clip it.
class Clipping {
 public:
  void add(ClipperLib::Paths paths);

  /// Stores the combination in `result`. Throws InputError if Clipper fails, and WorkError, before Clipper starts, if
  /// the work limit is exceeded.
  void execute(ClipperLib::ClipType operation, ClipperLib::PolyFillType rule, ClipperLib::PolyTree& result,
               const Work& work = {});

 private:
  ClipperLib::Clipper clipper_;
  ClipperLib::Paths paths_;
  ClipperLib::PolyType type_ = ClipperLib::ptSubject;  ///< role of the next paths added
};

/// The area of Clipper's result. Omits corners within 1.4 grid units of the line through their neighbours.
Area to_area(const ClipperLib::PolyTree& tree);

/// Combines the first area with all other areas at once. Each area covers the points with a nonzero winding number.
Area combined(std::span<const Area> areas, ClipperLib::ClipType operation, const Work& work = {});

/// The points inside an odd number of the paths.
Area even_odd_area(const ClipperLib::Paths& paths, const Work& work = {});

/// The points around which the winding number of the paths is not 0.
Area nonzero_area(const ClipperLib::Paths& paths, const Work& work = {});

}  // namespace csgsim::flat
