#pragma once

#include <span>
#include <string_view>

namespace csgsim::viewer {

/// An embedded file of `page/`.
struct PageFile {
  std::string_view name;
  std::string_view text;
};

std::span<const PageFile> page_files();

}  // namespace csgsim::viewer
