#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "host/view/camera.h"

namespace csgsim::testing {

/// The visible surface of a model's OpenSCAD mesh from one place, written by references.py.
struct Reference {
  static constexpr std::uint16_t nothing = 0;
  static constexpr std::uint16_t unjudged = 1;

  view::Camera camera;
  double near = 0;                    ///< depth of the value 2 in model units
  double far = 0;                     ///< depth of the value 65,535 in model units
  double diagonal = 0;                ///< diagonal of the mesh in model units
  std::uint32_t size = 0;             ///< width and height of the square picture
  std::vector<std::uint16_t> pixels;  ///< rows from the top

  /// The depth encoded by a value, in model units.
  [[nodiscard]] double depth_of(std::uint16_t value) const { return near + (far - near) * (value - 2) / 65533.0; }
};

/// Paths of the corpus's models by name.
std::map<std::string, std::string> corpus_models();

/// Reads FOLDER/NAME.png, square pictures above one another, with their lines of FOLDER/views.txt in reverse order.
/// Throws std::runtime_error if a picture or a line is missing.
std::vector<Reference> read_references(const std::filesystem::path& folder, const std::string& name);

/// Reads references/NAME.png with its lines of references/views.txt. Throws std::runtime_error if they do not exist.
std::vector<Reference> read_references(const std::string& model);

/// Models that are not drawn yet, with a part of csgsim's error message, from refused.txt.
std::map<std::string, std::string> refused_models();

}  // namespace csgsim::testing
