#pragma once

#include <optional>

#include "host/model/tree.h"
#include "host/read/arguments.h"
#include "host/read/nodes.h"

namespace csgsim::read {

/// The solid of a `cube`, `sphere`, `cylinder` or `polyhedron` node; nothing if it is empty. Throws std::logic_error
/// for a node of another kind.
std::optional<model::Shape> read_solid(NodeKind kind, const Arguments& arguments);

}  // namespace csgsim::read
