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
  /// Whether rotations of multmatrix() nodes are restored from the six digits that OpenSCAD writes (restore.h); their
  /// number is then reported.
  bool restores_rotations = false;
  /// An additional folder for imports. Both this folder and the model's folder are searched, with their subfolders; an
  /// imported file must be in one of them after links are followed. If empty, only the model's folder is used.
  std::filesystem::path imports_from{};
  /// Receives the bytes of each imported file, in order.
  std::function<void(std::string_view)> imported{};
  /// Limit on work. Reading throws an InputError with the position when the limit is exceeded.
  Work work{};
};

/// Reads an OpenSCAD `.csg` file. Throws InputError with file:line:column.
///
/// The result is a tree without empty parts. Solids with a zero, negative or non-finite size and solids flattened by a
/// singular matrix are empty. An empty operand makes an intersection empty, an empty first operand makes a difference
/// empty, and other empty operands are dropped; an operator with one remaining child is replaced by that child.
model::Tree read_csg_file(const std::filesystem::path& path, const Options& options = {});

/// Reads a mesh as a model that consists of its import(); the extension of `name` selects the format. Throws InputError
/// that begins with the name, also if the mesh has no faces.
model::Tree read_mesh(std::string bytes, std::string_view name, const Options& options = {});

/// Reads a `.csg` text; `name` replaces the file name in messages.
model::Tree read_csg_text(std::string_view text, std::string_view name, const Options& options = {});

}  // namespace csgsim::read
