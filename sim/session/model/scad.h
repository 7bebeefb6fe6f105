// Runs OpenSCAD on a model's source.
// Used by sim/session and sim/web.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace csgsim::session {

inline constexpr std::chrono::seconds default_openscad_time = std::chrono::minutes(30);

/// Options of OpenSCAD's command line that are passed on.
struct ScadOptions {
  std::vector<std::string> defines;  ///< NAME=VALUE of -D
  std::string parameters;            ///< file of parameter sets of -p; empty if there is none
  std::string parameter_set;         ///< the set of -P
  std::chrono::seconds time_limit = default_openscad_time;
};

/// Evaluates a source file with the OpenSCAD on the PATH and returns the text of a `.csg` file. `replacement` is
/// evaluated in place of the file's content, in the file's folder; messages name the file. OpenSCAD's messages go to
/// standard error. Throws InputError if OpenSCAD is missing, reports an error such as a failed assert(), or exceeds its
/// limits of time, memory or output.
std::string evaluate_scad(const std::string& file, const std::optional<std::string>& replacement,
                          const ScadOptions& options);

}  // namespace csgsim::session
