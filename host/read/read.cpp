#include "host/read/read.h"

#include <fmt/format.h>

#include <utility>

#include "host/read/build.h"
#include "host/read/meetings.h"
#include "host/read/root.h"
#include "host/read/source.h"
#include "host/read/syntax.h"
#include "hw/base/error.h"
#include "hw/base/input_file.h"

namespace csgsim::read {

namespace {

/// Visits the statements that are drawn. Throws InputError if the file has no statement.
void visit_drawn(Source& source, std::optional<std::uint32_t> root, StatementVisitor& visitor) {
  DrawnFilter filter(visitor, root);
  visit_statements(source, filter);
  if (!filter.has_statements())
    throw InputError(fmt::format("{}: no model found; export one from OpenSCAD", source.name()));
}

/// Finds where solids are combined. Only meshes need this.
Meetings find_meetings(Source& source, std::optional<std::uint32_t> root) {
  const auto names = [&](std::string_view node) { return source.text().find(node) != std::string_view::npos; };
  if (!names("polyhedron") && !names("import")) return {};
  MeetingFinder finder;
  visit_drawn(source, root, finder);
  return finder.meetings();
}

model::Tree read_source(Source& source, const Options& options) {
  source.set_work_counter(options.work);
  const std::optional<std::uint32_t> root = find_root_statement(source);
  TreeBuilder builder(source, options, find_meetings(source, root));
  visit_drawn(source, root, builder);
  return builder.finish();
}

}  // namespace

model::Tree read_csg_text(std::string_view text, std::string_view name, const Options& options) {
  Source source(text, name, options);
  return read_source(source, options);
}

model::Tree read_mesh(std::string bytes, std::string_view name, const Options& options) {
  Source source({name, std::move(bytes)}, name, options);
  model::Tree tree = read_source(source, options);
  if (tree.root == model::no_index)
    throw InputError(fmt::format("{}: the mesh has no faces, so there is nothing to draw; export it again", name));
  return tree;
}

model::Tree read_csg_file(const std::filesystem::path& path, const Options& options) {
  return read_csg_text(read_file(path, model_file), path.string(), options);
}

}  // namespace csgsim::read
