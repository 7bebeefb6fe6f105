#include "sim/shell/manual/description.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "hw/base/output_file.h"
#include "hw/kinds/load.h"
#include "sim/shell/settings/file_options.h"

namespace csgsim::shell {

namespace {

/// As file_options.h knows it: an operand's name is in small letters there.
std::string settings_name(const OptionHelp& option) {
  std::string name = long_name(option);
  if (name.empty()) name = option.names.front();
  std::ranges::transform(name, name.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return name;
}

}  // namespace

ValueKind kind_of(const OptionHelp& option) {
  if (option.type.empty()) return ValueKind::none;
  if (!option.words.empty()) return ValueKind::words;
  switch (role_of(settings_name(option))) {
    case FileRole::input:
    case FileRole::output: return ValueKind::file;
    case FileRole::machines: return ValueKind::machines;
    case FileRole::none: break;
  }
  return ValueKind::text;
}

std::vector<std::string> offered_words(const OptionHelp& option) {
  if (kind_of(option) != ValueKind::machines) return option.words;
  const std::vector<std::string_view> names = kinds::built_in_names();
  return {names.begin(), names.end()};
}

bool offers_files(const OptionHelp& option) {
  const ValueKind kind = kind_of(option);
  return kind == ValueKind::file || kind == ValueKind::machines;
}

void write_description(const Description& description, const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) fail_to_write(folder, error);
  std::vector<DescriptionFile> files = manual_pages(description);
  files.push_back({description.program + ".bash", bash_completion(description)});
  files.push_back({"_" + description.program, zsh_completion(description)});
  files.push_back({description.program + ".fish", fish_completion(description)});
  for (const DescriptionFile& file : files) write_file(std::filesystem::path(folder) / file.name, file.content);
}

}  // namespace csgsim::shell
