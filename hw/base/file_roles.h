#pragma once

#include <filesystem>
#include <optional>
#include <span>

namespace csgsim {

/// An output that is the same file as another one.
struct Clash {
  std::filesystem::path output;
  std::filesystem::path other;
  bool is_input = false;  ///< the other is read, else it is an output too
};

/// Whether writing would destroy what is read, or what was just written: compares files, not names, so links and
/// different ways to a folder are seen through. Character devices take any number of outputs, standard output by one of
/// its names takes one; `-` among the inputs is none of them. Throws InputError where
/// links lead in a circle.
std::optional<Clash> find_clash(std::span<const std::filesystem::path> inputs,
                                std::span<const std::filesystem::path> outputs);

}  // namespace csgsim
