#include "sim/software/convert/formats.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace csgsim::software::convert {

namespace {

constexpr std::array<const Format*, 3> format_rows{&stl_format, &off_format, &three_mf_format};

bool ends_so(std::string_view path, std::string_view ending) {
  const auto is_same = [](char one, char other) { return std::tolower(static_cast<unsigned char>(one)) == other; };
  return path.size() >= ending.size() && std::ranges::equal(path.substr(path.size() - ending.size()), ending, is_same);
}

}  // namespace

std::span<const Format* const> formats() { return format_rows; }

const Format* format_of(std::string_view path) {
  const auto found = std::ranges::find_if(format_rows, [&](const Format* row) { return ends_so(path, row->ending); });
  return found == format_rows.end() ? nullptr : *found;
}

}  // namespace csgsim::software::convert
