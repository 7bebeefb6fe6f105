// Embedded files of the page.
// Used by files.cpp.in and page.cpp.
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
