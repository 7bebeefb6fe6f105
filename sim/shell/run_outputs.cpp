#include "sim/shell/run_outputs.h"

#include <array>
#include <filesystem>
#include <vector>

#include "sim/observe/pictures.h"
#include "sim/shell/paths.h"

namespace csgsim::shell {

namespace {

void open(std::optional<OutputFile>& file, const std::string& name) {
  if (!name.empty()) file.emplace(name);
}

/// The file beside an owner picture that tells its colours; none if it holds indices.
std::string legend_of(const std::filesystem::path& owner_picture) {
  return observe::has_legend(owner_picture) && !is_unnamed_stream(owner_picture)
             ? std::filesystem::path(owner_picture).replace_extension(".json").native()
             : "";
}

}  // namespace

RunOutputs::RunOutputs(const RunOptions& options, std::span<const std::filesystem::path> inputs)
    : of_opaque_(options.surface == "opaque") {
  const std::string legend = legend_of(options.owner);
  refuse_clashes(inputs, std::to_array<std::filesystem::path>({options.picture, options.depth, options.owner, legend,
                                                               options.stats, options.report.file}));
  refuse_terminal("--output", options.picture);
  refuse_terminal("--depth", options.depth);
  refuse_terminal("--owner", options.owner);
  if (!options.picture.empty()) observe::check_format(options.picture);
  if (!options.depth.empty()) observe::check_depth_format(options.depth);
  if (!options.owner.empty()) observe::check_format(options.owner);
  open(picture_, options.picture);
  open(depth_, options.depth);
  open(owner_, options.owner);
  open(legend_, legend);
  open(stats_, options.stats);
  open(report_, options.report.file);
}

void RunOutputs::write_pictures(const observe::Frame& frame, const isa::Program& program) {
  if (picture_) observe::write_picture(*picture_, frame, program);
  if (!depth_ && !owner_) return;
  const observe::Frame surfaces = of_opaque_ ? observe::of_opaque(frame) : frame;
  if (depth_) observe::write_depth(*depth_, surfaces, program);
  if (!owner_) return;
  const observe::Frame of_primitives = observe::of_primitives(surfaces, program.facts);
  observe::write_owner(*owner_, of_primitives);
  if (legend_) observe::write_legend(*legend_, of_primitives, program);
}

void RunOutputs::write_stats(std::string_view json) {
  if (stats_) stats_->write(json);
}

void RunOutputs::write_report(const report::Page& page) {
  if (report_) report_->write(report::to_html(page));
}

void RunOutputs::commit() {
  std::vector<OutputFile*> files;
  for (std::optional<OutputFile>* file : {&picture_, &depth_, &owner_, &legend_, &stats_, &report_}) {
    if (*file) files.push_back(&**file);
  }
  commit_all(files);
}

}  // namespace csgsim::shell
