// Detects outputs that would overwrite inputs or other outputs.
// Used by sim/session.
#pragma once

#include <filesystem>
#include <optional>
#include <span>

namespace csgsim {

/// An output that is the same file as an input or as another output.
struct Clash {
  std::filesystem::path output;
  std::filesystem::path other;
  bool is_input = false;  ///< `other` is an input; otherwise it is also an output
};

/// Finds the first output that would overwrite an input or another output. Compares files, not names: it follows links
/// and resolves different paths to one folder. A character device may be named by several outputs. Standard output may
/// be named once, under any of its names; `-` among the inputs is standard input and never clashes. Throws InputError
/// for a cycle of symbolic links.
std::optional<Clash> find_clash(std::span<const std::filesystem::path> inputs,
                                std::span<const std::filesystem::path> outputs);

}  // namespace csgsim
