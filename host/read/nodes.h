#pragma once

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
  made,         ///< made of its children, if it takes any, when it has ended
  unsupported,  ///< a node of `.csg` files that has no half-spaces
  source,       ///< a module of OpenSCAD's language that its `.csg` files never contain
};

class Arguments;

/// Reads a solid. Nothing if it is empty.
using SolidReader = std::optional<model::Shape> (*)(const Arguments&);

/// Reads all arguments of a node that is made.
using MakerReader = Maker (*)(const Arguments&);

struct NodeType {
  std::string_view name;
  NodeKind kind;
  std::span<const std::string_view> parameters;  ///< those without a name in the file first, in their order
  std::size_t positional = 0;                    ///< how many of them may go without
  std::span<const std::string_view> harmless;    ///< accepted with any value: they change nothing here
  SolidReader solid = nullptr;                   ///< of a node of that kind
  MakerReader maker = nullptr;                   ///< of a node of that kind
  bool has_children = false;                     ///< of a node that is made
  std::uint32_t dimensions = 0;                  ///< of its children; 0: those of the first that is not empty
};

/// The node of that name, or nothing.
const NodeType* find_node(std::string_view name);

/// What is wrong with a name that find_node does not know, and what to do.
std::string unknown_node(std::string_view name);

/// What is wrong with an argument name that the node does not have, and what to do.
std::string unknown_argument(const NodeType& node, std::string_view name);

/// Why a node of kind `unsupported` or `source` cannot be used, and what to do.
std::string unusable_node(const NodeType& node);

}  // namespace csgsim::read
