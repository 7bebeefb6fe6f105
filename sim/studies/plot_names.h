#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace csgsim::studies {

/// A file's name without its ending, of at most so many bytes that endings and numbers fit behind it.
std::string plot_stem(const std::filesystem::path& model);

/// Names of plots, numbered from the second use on: `a`, `a-2`.
class PlotNames {
 public:
  std::string next(const std::string& name) {
    const unsigned use = ++uses_[name];
    return use == 1 ? name : name + "-" + std::to_string(use);
  }

 private:
  std::map<std::string, unsigned> uses_;
};

/// What an axis calls machines: one that is another of them with a figure changed is called by that figure alone, as
/// `pixel-planes-4` and `+alu.bits=2`.
std::vector<std::string> tick_names(std::span<const std::string> machines);

}  // namespace csgsim::studies
