#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace csgsim::read {

enum class NodeKind : std::uint8_t {
  unite,
  subtract,
  intersect,
  transform,
  colour,
  cube,
  sphere,
  cylinder,
  polyhedron,
  unsupported,  ///< a node of `.csg` files that has no half-spaces
  source,       ///< a module of OpenSCAD's language that its `.csg` files never contain
};

struct NodeType {
  std::string_view name;
  NodeKind kind;
  std::span<const std::string_view> parameters;  ///< those without a name in the file first, in their order
  std::size_t positional = 0;                    ///< how many of them may go without
  std::span<const std::string_view> harmless;    ///< accepted with any value: they change nothing here
};

/// The node of that name, or nothing.
const NodeType* find_node(std::string_view name);

/// What is wrong with a name that find_node does not know, and what to do.
std::string unknown_node(std::string_view name);

/// What is wrong with an argument name that the node does not have, and what to do.
std::string unknown_argument(const NodeType& node, std::string_view name);

/// Why a node of kind `unsupported` or `source` cannot be used, and what to do.
std::string unusable_node(const NodeType& node);

/// The candidate that is the fewest edits away, or an empty name if none is near.
std::string_view near_name(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace csgsim::read
