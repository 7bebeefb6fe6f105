#include "sim/viewer/page.h"

#include <algorithm>
#include <array>
#include <string>

#include "sim/report/parts_html.h"
#include "sim/viewer/files.h"

namespace csgsim::viewer {

namespace {

struct Type {
  std::string_view ending;
  std::string_view type;
};

constexpr auto types = std::to_array<Type>({{".html", "text/html; charset=utf-8"},
                                            {".css", "text/css; charset=utf-8"},
                                            {".js", "text/javascript; charset=utf-8"}});

Reply reply(std::string_view name, std::string_view text) {
  const auto* const type = std::ranges::find_if(types, [&](const Type& one) { return name.ends_with(one.ending); });
  return {.type = std::string(type->type), .body = std::string(text)};
}

}  // namespace

std::optional<Reply> page_file(std::string_view path) {
  const std::string_view name = path.empty() ? "page.html" : path;
  if (name == "page.css") return reply(name, report::page_style);
  const auto files = page_files();
  const auto file = std::ranges::find(files, name, &PageFile::name);
  if (file == files.end()) return std::nullopt;
  return reply(name, file->text);
}

}  // namespace csgsim::viewer
