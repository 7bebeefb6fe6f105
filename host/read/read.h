// Reader of OpenSCAD `.csg` files.
// Used by build.h, source.h, host/commands and sim.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::read {

struct Options {
  /// Restores rotations of multmatrix() nodes from the six digits that OpenSCAD writes (restore.h), and reports their
  /// number.
  bool restores_rotations = false;
  /// An additional folder for imports. Imported files have to be, after links are followed, in the model's folder, in
  /// this one, or below them; both are searched. Empty: only the model's folder.
  std::filesystem::path imports_from{};
  /// Receives the bytes of each imported file, in order.
  std::function<void(std::string_view)> imported{};
  /// Limit on work; reading throws an InputError with the position beyond it.
  Work work{};
};

/// Reads an OpenSCAD `.csg` file. Throws InputError with file:line:column.
///
/// The result is a tree without empty parts. Solids with a zero, negative or non-finite size and solids flattened by a
/// singular matrix are empty. An empty operand empties an intersection, an empty first operand a difference, and other
/// empty operands are dropped; an operator with one remaining child is replaced by it.
model::Tree read_csg_file(const std::filesystem::path& path, const Options& options = {});

/// The same for a text; `name` replaces the file name in messages.
model::Tree read_csg_text(std::string_view text, std::string_view name, const Options& options = {});

}  // namespace csgsim::read
