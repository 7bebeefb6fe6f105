// Names of plots and labels of machines on axes.
// Used by the studies that draw plots.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace csgsim::studies {

/// The file name without extension, shortened so that extensions and numbers can be appended.
std::string plot_stem(const std::filesystem::path& model);

/// Names of plots; repeated names are numbered: `a`, `a-2`.
class PlotNames {
 public:
  std::string next(const std::string& name) {
    const unsigned use = ++uses_[name];
    return use == 1 ? name : name + "-" + std::to_string(use);
  }

 private:
  std::map<std::string, unsigned> uses_;
};

/// Labels of machines on an axis. A machine that is another one with changed parameters is labelled by the change only:
/// `pixel-planes-4` and `+alu.bits=2`.
std::vector<std::string> machine_tick_labels(std::span<const std::string> machines);

}  // namespace csgsim::studies
