#include "hw/kinds/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/nearest.h"
#include "hw/kinds/rows.h"
#include "hw/machines/description.h"

namespace csgsim::kinds {

namespace {

constexpr InputKind machine_file{"a machine file, which ends in .toml", std::size_t{1} << 20U,
                                 "a machine is described in far less"};

constexpr std::string_view file_ending = ".toml";

/// Those of `+KEY=VALUE+KEY=VALUE`.
std::vector<std::string> changes_of(std::string_view text) {
  std::vector<std::string> changes;
  while (!text.empty()) {
    text.remove_prefix(1);
    const std::size_t end = std::min(text.find('+'), text.size());
    changes.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return changes;
}

}  // namespace

std::vector<std::string_view> built_in_names() {
  std::vector<std::string_view> names;
  for (const BuiltIn& machine : built_in()) names.push_back(machine.name);
  return names;
}

std::string_view file_of(std::string_view machine) {
  if (machine.ends_with(file_ending)) return machine;
  const std::string_view name = machine.substr(0, machine.find('+'));
  return name.ends_with(file_ending) ? name : std::string_view();
}

machines::Machine load(const std::string& machine) {
  const std::string file(file_of(machine));
  const std::string name = file.empty() ? machine.substr(0, machine.find('+')) : file;
  const std::vector<std::string> changes = changes_of(std::string_view(machine).substr(name.size()));
  if (!file.empty()) return machines::read_description(read_file(file, machine_file), file, all(), changes);
  const auto found =
      std::find_if(built_in().begin(), built_in().end(), [&name](const BuiltIn& one) { return one.name == name; });
  if (found == built_in().end())
    throw InputError(no_such("machine", name, built_in_names()) + ", or a file, whose name ends in .toml");
  return machines::read_description(found->text, fmt::format("{}.toml", found->name), all(), changes);
}

}  // namespace csgsim::kinds
