// Table of node types.
// Used by arguments.h, build.h, meetings.cpp and solids.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "host/model/tree.h"
#include "host/read/operands.h"

namespace csgsim::read {

enum class NodeKind : std::uint8_t {
  unite,
  subtract,
  intersect,
  transform,
  colour,
  solid,        ///< a convex solid
  made,         ///< made when the node ends, from its children if it may have children
  unsupported,  ///< a node of `.csg` files that cannot be represented by half-spaces
  source,       ///< a module of OpenSCAD's language that never occurs in its `.csg` files
};

class Arguments;

/// Reads a solid; the result is empty if the solid is.
using SolidReader = std::optional<model::Shape> (*)(const Arguments&);

/// Reads all arguments of a made node.
using MakerReader = Maker (*)(const Arguments&);

struct NodeType {
  std::string_view name;
  NodeKind kind;
  std::span<const std::string_view> parameters;  ///< positional ones first, in order
  std::size_t positional = 0;                    ///< number of parameters that may be positional
  std::span<const std::string_view> harmless;    ///< accepted with any value, and ignored
  SolidReader solid = nullptr;                   ///< for kind `solid` only
  MakerReader maker = nullptr;                   ///< for kind `made` only
  bool has_children = false;                     ///< for kind `made` only: whether it may have children
  std::uint32_t dimensions = 0;  ///< dimensions of its children; 0 if they are those of the first non-empty child
};

/// Arguments that are accepted and ignored: of any node, and of solids whose parameters are not $fn, $fa and $fs.
inline constexpr std::array<std::string_view, 2> common_extras{"convexity", "timestamp"};
inline constexpr std::array<std::string_view, 5> solid_extras{"convexity", "timestamp", "$fn", "$fa", "$fs"};

/// The rows of convex solids (solids.cpp).
std::span<const NodeType> solid_node_types();

/// The node type with the given name; null if there is none.
const NodeType* find_node_type(std::string_view name);

/// The error text for a name unknown to find_node_type(), with a suggestion.
std::string unknown_node_text(std::string_view name);

/// The error text for an argument name that the node does not have, with a suggestion.
std::string unknown_argument_text(const NodeType& node, std::string_view name);

/// The error text for a node of kind `unsupported` or `source`, with a suggestion.
std::string unusable_node_text(const NodeType& node);

}  // namespace csgsim::read
