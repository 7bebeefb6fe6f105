// The table of display methods.
// Used by sim/app and sim/studies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "sim/software/display/faults.h"
#include "sim/software/display/phases.h"
#include "sim/software/draw.h"
#include "sim/software/facets/facets.h"
#include "sim/software/tree/tree.h"

namespace csgsim::software {

/// Inputs of a display method.
struct DisplaySubject {
  const model::Tree& model;
  const facet::Geometry& geometry;
  const view::View& view;
  const Tree& tree;  ///< tree of the model, in some shape
  const Facets& facets;
  std::size_t bucket_size = 24;           ///< maximum polygons per bucket, for methods with buckets
  std::string_view directory = "excell";  ///< directory of the buckets; must halve space

  /// 2^n - 1, the depth where nothing is visible.
  [[nodiscard]] std::uint32_t farthest() const { return (std::uint32_t{1} << view.sampling.z_bits) - 1; }
  [[nodiscard]] std::size_t pixels() const { return std::size_t{view.sampling.width} * view.sampling.height; }
};

/// A picture and its cost.
struct Displayed {
  Picture picture;
  DisplayCounts counts;              ///< complete only with counting; words and numbers of polygons are always set
  Faults faults;                     ///< only with counting, for methods that are not exact
  double preprocessing_seconds = 0;  ///< wall time on this computer
  double drawing_seconds = 0;        ///< wall time on this computer, without preprocessing
};

/// A row of the table of methods that draw facet by facet.
struct DisplayRow {
  std::string_view name;
  std::string_view help;
  std::string_view source;
  bool is_exact = true;  ///< exact at every pixel by construction
  /// With `counts`, the method counts operations and is slower. Throws InputError if a face exceeds the number range of
  /// the machines.
  Displayed (*run)(const DisplaySubject& subject, bool counts) = nullptr;
};

std::span<const DisplayRow* const> display_methods();

/// Finds a method by name. Throws InputError that lists the valid names.
const DisplayRow& display_method(const std::string& name);

}  // namespace csgsim::software
