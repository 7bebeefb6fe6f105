#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "host/view/camera.h"

namespace csgsim::testing {

/// What OpenSCAD's mesh of a model says is to be seen from one place: references.py writes it.
struct Reference {
  static constexpr std::uint16_t nothing = 0;
  static constexpr std::uint16_t unjudged = 1;

  view::Camera camera;
  double near = 0;                    ///< depth of the value 2, model units
  double far = 0;                     ///< depth of the value 65,535
  double diagonal = 0;                ///< of the mesh, model units
  std::uint32_t size = 0;             ///< the picture is square
  std::vector<std::uint16_t> pixels;  ///< rows from the top

  /// Depth that a value stands for, model units.
  [[nodiscard]] double depth_of(std::uint16_t value) const { return near + (far - near) * (value - 2) / 65533.0; }
};

/// Models of the corpus by name, each with its file's path.
std::map<std::string, std::string> corpus_models();

/// Reads references/NAME.png with its lines of references/views.txt. Throws std::runtime_error where there are none.
std::vector<Reference> read_references(const std::string& model);

/// Models that are not drawn yet, and what csgsim says against each (a part of its message): refused.txt.
std::map<std::string, std::string> refused_models();

}  // namespace csgsim::testing
