#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "host/swept/element.h"
#include "hw/base/work.h"

namespace csgsim::swept {

/// What lets an element be.
enum class Flatness : std::uint8_t {
  plane,  ///< of the thesis: its fourth corner and its midpoint are near the plane of three corners
  sides   ///< and its sides, too, are near the lines between its corners
};

struct Accuracy {
  double tolerance = 0.1;  ///< model units
  Flatness flatness = Flatness::sides;
  std::uint32_t most_levels = 12;  ///< halvings of a patch, `deepest` at most
  Work work{};
};

/// Operations on coordinates, however a processor does them.
struct Arithmetic {
  std::uint64_t adds = 0;  ///< differences and halves, too
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

/// What subdividing did.
struct SubdivisionCounts {
  std::uint64_t nodes = 0;     ///< of the quadtrees, leaves among them
  std::uint64_t elements = 0;  ///< leaves
  std::uint64_t points = 0;    ///< of the surface that were worked out
  std::uint64_t tests = 0;     ///< distances from a plane or a line
  std::uint64_t halvings = 0;  ///< of curves; of a patch, of its coefficients along u or v
  std::uint64_t sections = 0;  ///< places of a contour along its trajectory
  Arithmetic arithmetic;       ///< of all of that
};

inline constexpr std::size_t most_patches = 100'000;       ///< of a surface
inline constexpr std::uint64_t most_elements = 2'000'000;  ///< of a surface

/// Patches in columns (u) and rows (v), each next to the one before.
class Surface {
 public:
  Surface() = default;
  virtual ~Surface() = default;
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  [[nodiscard]] virtual std::size_t columns() const = 0;
  [[nodiscard]] virtual std::size_t rows() const = 0;
  [[nodiscard]] virtual bool wraps_columns() const { return false; }  ///< behind the last column is the first
  [[nodiscard]] virtual bool wraps_rows() const { return false; }

  /// The quadtree of a patch (algorithm 3.1). The surface and the counts have to outlive it. Its next() throws
  /// InputError where the levels do not suffice for the tolerance and where the counts have more than `most_elements`,
  /// and WorkError past the limit on work.
  virtual std::unique_ptr<Stream> subdivide(std::size_t column, std::size_t row, const Accuracy& accuracy,
                                            SubdivisionCounts& counts) = 0;
};

}  // namespace csgsim::swept
