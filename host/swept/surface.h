// Interface of subdivided surfaces: accuracy, counts and patches.
// Used throughout host/swept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "host/swept/element.h"
#include "hw/base/work.h"

namespace csgsim::swept {

/// The condition under which an element needs no further subdivision.
enum class Flatness : std::uint8_t {
  plane,  ///< the thesis's test: the fourth corner and the midpoint are close to the plane of three corners
  sides   ///< the sides are also close to the lines between the corners
};

struct Accuracy {
  double tolerance = 0.1;  ///< model units
  Flatness flatness = Flatness::sides;
  std::uint32_t max_levels = 12;  ///< maximum number of halvings of a patch, at most `max_depth`
  Work work{};
};

/// Numbers of operations on coordinates, independent of the processor.
struct Arithmetic {
  std::uint64_t adds = 0;  ///< including differences and halvings
  std::uint64_t products = 0;
  std::uint64_t quotients = 0;
  std::uint64_t roots = 0;

  Arithmetic& operator+=(const Arithmetic& more) {
    adds += more.adds;
    products += more.products;
    quotients += more.quotients;
    roots += more.roots;
    return *this;
  }
};

/// Counts of a subdivision.
struct SubdivisionCounts {
  std::uint64_t nodes = 0;     ///< nodes of the quadtrees, including leaves
  std::uint64_t elements = 0;  ///< leaves
  std::uint64_t points = 0;    ///< evaluated points of the surface
  std::uint64_t tests = 0;     ///< number of distances computed from a plane or a line
  std::uint64_t halvings = 0;  ///< number of halvings of curves; for a patch, of its coefficients along u or v
  std::uint64_t sections = 0;  ///< number of positions of the contour along the trajectory
  Arithmetic arithmetic;       ///< total of all of these operations
};

inline constexpr std::size_t max_patches = 100'000;        ///< per surface
inline constexpr std::uint64_t most_elements = 2'000'000;  ///< per surface

/// Patches in columns (u) and rows (v), each adjacent to the previous one.
class Surface {
 public:
  Surface() = default;
  virtual ~Surface() = default;
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  [[nodiscard]] virtual std::size_t columns() const = 0;
  [[nodiscard]] virtual std::size_t rows() const = 0;
  /// Whether the first column follows the last column.
  [[nodiscard]] virtual bool wraps_columns() const { return false; }
  [[nodiscard]] virtual bool wraps_rows() const { return false; }

  /// The quadtree of a patch (algorithm 3.1). The surface and the counts must outlive it. Its next() throws InputError
  /// if the levels do not suffice for the tolerance or there are more than `most_elements` elements, and WorkError if
  /// the work limit is exceeded.
  virtual std::unique_ptr<Stream> subdivide(std::size_t column, std::size_t row, const Accuracy& accuracy,
                                            SubdivisionCounts& counts) = 0;
};

}  // namespace csgsim::swept
