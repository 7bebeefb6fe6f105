#include "sim/app/run_outputs.h"

#include <array>
#include <filesystem>
#include <vector>

#include "sim/app/paths.h"
#include "sim/observe/pictures.h"

namespace csgsim::app {

namespace {

void open(std::optional<OutputFile>& file, const std::string& name) {
  if (!name.empty()) file.emplace(name);
}

}  // namespace

RunOutputs::RunOutputs(const RunOptions& options, std::span<const std::filesystem::path> inputs) {
  refuse_clashes(inputs,
                 std::to_array<std::filesystem::path>({options.picture, options.depth, options.owner, options.stats}));
  if (!options.picture.empty()) sim::check_format(options.picture);
  open(picture_, options.picture);
  open(depth_, options.depth);
  open(owner_, options.owner);
  open(stats_, options.stats);
}

void RunOutputs::write_pictures(const sim::Frame& frame, const isa::Program& program) {
  if (picture_) sim::write_picture(*picture_, frame, program);
  if (depth_) sim::write_depth(*depth_, frame, program);
  if (owner_) sim::write_owner(*owner_, frame);
}

void RunOutputs::write_stats(std::string_view json) {
  if (stats_) stats_->write(json);
}

void RunOutputs::commit() {
  std::vector<OutputFile*> files;
  for (std::optional<OutputFile>* file : {&picture_, &depth_, &owner_, &stats_}) {
    if (*file) files.push_back(&**file);
  }
  commit_all(files);
}

}  // namespace csgsim::app
