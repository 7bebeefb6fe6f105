#include "sim/software/convert/formats.h"

#include <algorithm>
#include <cctype>

namespace csgsim::software::convert {

namespace {

bool ends_so(std::string_view path, std::string_view ending) {
  const auto is_same = [](char one, char other) { return std::tolower(static_cast<unsigned char>(one)) == other; };
  return path.size() >= ending.size() && std::ranges::equal(path.substr(path.size() - ending.size()), ending, is_same);
}

}  // namespace

const Format* format_of(std::string_view path) {
  const std::span<const Format* const> rows = formats();
  const auto found = std::ranges::find_if(rows, [&](const Format* row) { return ends_so(path, row->ending); });
  return found == rows.end() ? nullptr : *found;
}

}  // namespace csgsim::software::convert
