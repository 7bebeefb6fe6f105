#include "sim/shell/settings/file_options.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "hw/kinds/load.h"

namespace csgsim::shell {

namespace {

constexpr auto roles = std::to_array<std::pair<std::string_view, FileRole>>({
    {"model", FileRole::input},
    {"program", FileRole::input},
    {"a", FileRole::input},
    {"b", FileRole::input},
    {"file", FileRole::input},
    {"scene", FileRole::input},
    {"imports-from", FileRole::input},
    {"commands", FileRole::input},
    {"config", FileRole::input},
    {"from", FileRole::input},
    {"output", FileRole::output},
    {"depth", FileRole::output},
    {"owner", FileRole::output},
    {"stats", FileRole::output},
    {"json", FileRole::output},
    {"report", FileRole::output},
    {"checkpoint", FileRole::output},
    {"resume", FileRole::output},
    {"machine", FileRole::machines},
    {"machines", FileRole::machines},
    {"machine-a", FileRole::machines},
    {"machine-b", FileRole::machines},
});

std::string file_in(std::string_view name, const std::string& folder) {
  const bool stays = name.empty() || name == "-" || folder.empty();
  return stays ? std::string(name) : (std::filesystem::path(folder) / name).native();
}

}  // namespace

FileRole role_of(std::string_view option) {
  const auto* const row = std::ranges::find(roles, option, &std::pair<std::string_view, FileRole>::first);
  return row == roles.end() ? FileRole::none : row->second;
}

std::string in_folder(std::string_view option, const std::string& value, const std::string& folder) {
  const FileRole role = role_of(option);
  if (role == FileRole::none) return value;
  if (role != FileRole::machines) return file_in(value, folder);
  std::string all;
  for (std::size_t begin = 0; begin <= value.size();) {
    const std::size_t end = std::min(value.find(',', begin), value.size());
    const std::string_view one = std::string_view(value).substr(begin, end - begin);
    if (begin > 0) all += ',';
    all += kinds::file_of(one).empty() ? std::string(one) : file_in(one, folder);
    begin = end + 1;
  }
  return all;
}

}  // namespace csgsim::shell
