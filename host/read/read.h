#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "host/model/tree.h"

namespace csgsim::read {

/// Reads an OpenSCAD `.csg` file. Throws InputError with file:line:column.
///
/// What stays: a tree without empty parts. Solids of zero, negative or non-finite size and solids flattened by a
/// singular matrix are empty; an empty operand empties an intersection, an empty first operand a difference, and other
/// empty operands vanish; operators left with one child are replaced by it.
model::Tree read_csg_file(const std::filesystem::path& path);

/// The same from text; `name` stands for the file in messages.
model::Tree read_csg_text(std::string_view text, std::string_view name);

}  // namespace csgsim::read
