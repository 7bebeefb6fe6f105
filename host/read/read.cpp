#include "host/read/read.h"

#include "host/read/build.h"
#include "host/read/meetings.h"
#include "host/read/root.h"
#include "host/read/source.h"
#include "host/read/syntax.h"

namespace csgsim::read {

namespace {

/// Has a visitor told of the statements that are drawn: those of the file, or the one under `!`.
void visit_drawn(Source& source, std::optional<std::uint32_t> root, StatementVisitor& visitor) {
  if (!root) return visit_statements(source, visitor);
  RootFilter filter(visitor, *root);
  visit_statements(source, filter);
}

/// Only meshes ask where solids meet.
Meetings find_meetings(Source& source, std::optional<std::uint32_t> root) {
  const auto names = [&](std::string_view node) { return source.text().find(node) != std::string_view::npos; };
  if (!names("polyhedron") && !names("import")) return {};
  MeetingFinder finder;
  visit_drawn(source, root, finder);
  return finder.meetings();
}

}  // namespace

model::Tree read_csg_text(std::string_view text, std::string_view name, const Options& options) {
  Source source(text, name, options);
  source.charge_to(options.work);
  const std::optional<std::uint32_t> root = find_root(source);
  TreeBuilder builder(source, options, find_meetings(source, root));
  visit_drawn(source, root, builder);
  return builder.finish();
}

model::Tree read_csg_file(const std::filesystem::path& path, const Options& options) {
  const std::string name = path.string();
  const std::string text = load(name);
  return read_csg_text(text, name, options);
}

}  // namespace csgsim::read
