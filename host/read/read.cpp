#include "host/read/read.h"

#include "host/read/build.h"
#include "host/read/root.h"
#include "host/read/source.h"
#include "host/read/syntax.h"

namespace csgsim::read {

model::Tree read_csg_text(std::string_view text, std::string_view name, const Options& options) {
  Source source(text, name, options.imports_from);
  TreeBuilder builder(source, options);
  if (const std::optional<std::uint32_t> root = find_root(source)) {
    RootFilter filter(builder, *root);
    visit_statements(source, filter);
  } else {
    visit_statements(source, builder);
  }
  return builder.finish();
}

model::Tree read_csg_file(const std::filesystem::path& path, const Options& options) {
  const std::string name = path.string();
  const std::string text = load(name);
  return read_csg_text(text, name, options);
}

}  // namespace csgsim::read
