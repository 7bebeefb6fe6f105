// Output files of a run.
// Used by sim/session, sim/app and sim/python.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "hw/base/output_file.h"
#include "sim/session/run/run_request.h"

namespace csgsim::session {

/// The output files of a run. They are opened before it, so that bad names fail early, and committed together at its
/// end.
class RunOutputs {
 public:
  /// Throws UsageError for a file that is an input or another output, InputError for one that cannot be written.
  RunOutputs(const RunRequest& request, std::span<const std::filesystem::path> inputs);

  /// Writes the requested pictures: colours, depths, owners and their legend.
  void write_pictures(const observe::Frame& frame, const isa::Program& program);
  void write_stats(std::string_view json);
  void write_report(const report::Page& page);
  /// Commits all files as a group.
  void commit();

 private:
  /// Kinds of output files; `legend` belongs to the owner picture.
  enum Output : std::uint8_t { picture, depth, owner, legend, stats, page };

  bool of_opaque_;  ///< depth and owner show opaque surfaces
  std::array<std::optional<OutputFile>, page + 1> files_;
};

}  // namespace csgsim::session
