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

/// What is displayed.
struct DisplaySubject {
  const model::Tree& model;
  const facet::Geometry& geometry;
  const view::View& view;
  const Tree& tree;  ///< of the model, in some shape
  const Facets& facets;
  std::size_t bucket_size = 24;           ///< polygons that a bucket takes, of methods that have any
  std::string_view directory = "excell";  ///< of the same, one that halves space

  /// 2^n - 1, where nothing is seen.
  [[nodiscard]] std::uint32_t farthest() const { return (std::uint32_t{1} << view.sampling.z_bits) - 1; }
  [[nodiscard]] std::size_t pixels() const { return std::size_t{view.sampling.width} * view.sampling.height; }
};

/// A picture, and what it took.
struct Displayed {
  Picture picture;
  DisplayCounts counts;              ///< where it was counted; words and numbers of polygons always
  Faults faults;                     ///< the same; of methods that are not exact
  double preprocessing_seconds = 0;  ///< wall time on this computer
  double drawing_seconds = 0;        ///< the same, of all but preprocessing
};

/// A row of the table of methods that draw facet by facet.
struct DisplayRow {
  std::string_view name;
  std::string_view help;
  std::string_view source;
  bool is_exact = true;  ///< at every pixel, by construction
  /// `counts`: it tells what it does, and is slower. Throws InputError for a face that does not fit the numbers of
  /// machines.
  Displayed (*run)(const DisplaySubject& subject, bool counts) = nullptr;
};

std::span<const DisplayRow* const> display_methods();

/// By name. Throws InputError that lists what there is.
const DisplayRow& display_method(const std::string& name);

}  // namespace csgsim::software
