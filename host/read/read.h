#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::read {

struct Options {
  /// Rotations of multmatrix() nodes are restored from the six digits that OpenSCAD writes (restore.h), and a
  /// note says how many.
  bool restores_rotations = false;
  /// Files that the model imports have to be, when links are followed, in the model's folder, in this one, or below
  /// them, and are looked for in both; empty: in the model's alone.
  std::filesystem::path imports_from{};
  /// Is told the bytes of each file that is imported, in order.
  std::function<void(std::string_view)> imported{};
  /// Reading throws an InputError, with the place, past its limit.
  Work work{};
};

/// Reads an OpenSCAD `.csg` file. Throws InputError with file:line:column.
///
/// What stays: a tree without empty parts. Solids of zero, negative or non-finite size and solids flattened by a
/// singular matrix are empty; an empty operand empties an intersection, an empty first operand a difference, and other
/// empty operands vanish; operators left with one child are replaced by it.
model::Tree read_csg_file(const std::filesystem::path& path, const Options& options = {});

/// The same from text; `name` stands for the file in messages.
model::Tree read_csg_text(std::string_view text, std::string_view name, const Options& options = {});

}  // namespace csgsim::read
