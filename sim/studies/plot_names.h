#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace csgsim::studies {

/// A file's name without its ending, of at most so many bytes that endings and numbers fit behind it.
std::string plot_stem(const std::filesystem::path& model);

/// What an axis calls machines: one that is another of them with a figure changed is called by that figure alone, as
/// `pixel-planes-4` and `+alu.bits=2`.
std::vector<std::string> tick_names(std::span<const std::string> machines);

}  // namespace csgsim::studies
