// The model that a file of commands defines.
// Used by interpreter.h and read.h.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "host/model/tree.h"
#include "host/swept/net.h"
#include "host/swept/sweep.h"

namespace csgsim::commands {

/// Marks an index that refers to no solid.
inline constexpr std::uint32_t nothing = 0xffffffffU;

/// A sweep defined in a file.
struct SweptSolid {
  std::string_view name;
  std::uint32_t offset = 0;
  swept::Sweep sweep;
  double tolerance = 0;
};

/// A patch defined in a file; a patch is not a solid.
struct Patch {
  std::string_view name;
  std::uint32_t offset = 0;
  swept::Net net;
  double tolerance = 0;
};

struct MovedSolid {
  glm::dmat4 matrix{1};
  std::uint32_t solid = nothing;
};

struct ColouredSolid {
  glm::dvec3 colour{0};
  std::uint32_t solid = nothing;
};

struct CombinedSolid {
  model::Operator op = model::Operator::unite;
  std::uint32_t left = nothing;
  std::uint32_t right = nothing;
};

struct Swept {
  std::uint32_t number = 0;  ///< index into Model::sweeps
};

/// A solid that a line defines, possibly from earlier solids. Several later solids may refer to it.
struct Solid {
  std::variant<model::Shape, Swept, CombinedSolid, MovedSolid, ColouredSolid> made;
  model::Location location;
};

/// The solids, sweeps and patches that the lines of a file define.
struct Model {
  std::vector<Solid> solids;
  std::vector<SweptSolid> sweeps;
  std::vector<Patch> patches;
  /// Index of the solid to draw: `Object` if defined, otherwise the last solid assigned to a name.
  std::uint32_t drawn = nothing;
};

}  // namespace csgsim::commands
