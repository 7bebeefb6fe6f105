#include "sim/viewer/page.h"

#include <algorithm>
#include <array>
#include <string>

#include "sim/report/parts_html.h"
#include "sim/viewer/files.h"

namespace csgsim::viewer {

namespace {

struct File {
  std::string_view path;
  std::string_view type;
  const std::string_view* text;
};

constexpr auto files = std::to_array<File>({{"", "text/html; charset=utf-8", &page_html},
                                            {"page.css", "text/css; charset=utf-8", &report::page_style},
                                            {"view.css", "text/css; charset=utf-8", &view_style},
                                            {"view.js", "text/javascript; charset=utf-8", &view_script}});

}  // namespace

std::optional<Reply> page_file(std::string_view path) {
  const auto* const file = std::ranges::find(files, path, &File::path);
  if (file == files.end()) return std::nullopt;
  return Reply{.type = std::string(file->type), .body = std::string(*file->text)};
}

}  // namespace csgsim::viewer
