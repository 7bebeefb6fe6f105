#include "sim/session/run/run_outputs.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <vector>

#include "hw/isa/facts.h"
#include "sim/observe/pictures.h"
#include "sim/report/page.h"
#include "sim/session/options/paths.h"

namespace csgsim::session {

namespace {

/// The legend file beside an owner picture; empty if the picture holds indices.
std::string legend_of(const std::filesystem::path& owner_picture) {
  return observe::has_legend(owner_picture) && !is_unnamed_stream(owner_picture)
             ? std::filesystem::path(owner_picture).replace_extension(".json").native()
             : "";
}

}  // namespace

RunOutputs::RunOutputs(const RunRequest& request, std::span<const std::filesystem::path> inputs)
    : of_opaque_(request.surface == "opaque") {
  const std::array<std::filesystem::path, page + 1> names{request.picture,          request.depth, request.owner,
                                                          legend_of(request.owner), request.stats, request.report.file};
  refuse_clashes(inputs, names);
  refuse_terminal("--output", request.picture);
  refuse_terminal("--depth", request.depth);
  refuse_terminal("--owner", request.owner);
  refuse_unknown_format("--output", request.picture);
  if (!request.depth.empty()) observe::check_depth_format(request.depth);
  refuse_unknown_format("--owner", request.owner);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!names[i].empty()) files_[i].emplace(names[i]);
}

void RunOutputs::write_pictures(const observe::Frame& frame, const isa::Program& program) {
  if (files_[picture]) observe::write_picture(*files_[picture], frame, program);
  if (!files_[depth] && !files_[owner]) return;
  const observe::Frame surfaces = of_opaque_ ? observe::with_opaque_surfaces(frame) : frame;
  if (files_[depth]) observe::write_depth(*files_[depth], surfaces, program);
  if (!files_[owner]) return;
  const observe::Frame of_primitives = observe::with_primitive_owners(surfaces, *program.facts);
  observe::write_owner(*files_[owner], of_primitives);
  if (files_[legend]) observe::write_legend(*files_[legend], of_primitives, program);
}

void RunOutputs::write_stats(std::string_view json) {
  if (files_[stats]) files_[stats]->write(json);
}

void RunOutputs::write_report(const report::Page& written) {
  if (files_[page]) files_[page]->write(report::to_html(written));
}

void RunOutputs::commit() {
  std::vector<OutputFile*> files;
  for (std::optional<OutputFile>& file : files_)
    if (file) files.push_back(&*file);
  commit_all(files);
}

}  // namespace csgsim::session
