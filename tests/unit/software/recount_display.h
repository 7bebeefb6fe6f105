#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/software/display/rows.h"
#include "sim/software/facets/facets.h"
#include "sim/software/tree/tree.h"
#include "tests/unit/software/recount_pixels.h"
#include "tests/unit/software/recount_sequences.h"

namespace csgsim::testing {

/// A displayed scene with its facets on the screen and ray events, and the expected counts.
struct DisplayRecount {
  const Scene& scene;
  PlainTree tree;
  std::size_t primitives;
  software::Tree binary;
  software::Facets facets;
  software::ScreenFacets screen;
  PixelEvents rays;
  std::vector<FacetScan> scans;  ///< one per facet on the screen
  Numbers numbers;
  std::uint32_t farthest;
  std::vector<software::VisibleSurface> seen;  ///< the picture
  software::Counts csg;                        ///< counts of classification
  software::DisplayCounts expected;

  /// Sets the costs common to all methods. Keeps a reference.
  explicit DisplayRecount(const Scene& scene);

  [[nodiscard]] Operations& of(software::Phase phase) { return expected.operations[static_cast<std::size_t>(phase)]; }
  [[nodiscard]] std::size_t pixel(const FacetEvent& one) const {
    return static_cast<std::size_t>(one.row) * scene.view.sampling.width + static_cast<std::size_t>(one.column);
  }
  [[nodiscard]] software::Displayed by(const std::string& method, std::size_t bucket_size = 24,
                                       std::string_view directory = "excell") const;
  /// Adds classification to scan conversion, and checks the picture and all counts.
  void check(const software::Displayed& found);
};

void check_same(const Operations& found, const Operations& expected);
void check_same(const software::Counts& found, const software::Counts& expected);

}  // namespace csgsim::testing
