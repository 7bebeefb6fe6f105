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

}  // namespace

std::vector<std::string_view> built_in_names() {
  std::vector<std::string_view> names;
  for (const BuiltIn& machine : built_in()) names.push_back(machine.name);
  return names;
}

bool is_file(std::string_view name_or_file) { return name_or_file.ends_with(".toml"); }

machines::Machine load(const std::string& name_or_file) {
  if (is_file(name_or_file)) {
    return machines::read_description(read_file(name_or_file, machine_file), name_or_file, all());
  }
  const auto found = std::find_if(built_in().begin(), built_in().end(),
                                  [&name_or_file](const BuiltIn& machine) { return machine.name == name_or_file; });
  if (found == built_in().end())
    throw InputError(fmt::format("unknown machine '{}'; the nearest known is '{}', and a file's name ends in .toml",
                                 name_or_file, nearest(name_or_file, built_in_names())));
  return machines::read_description(found->text, fmt::format("{}.toml", found->name), all());
}

}  // namespace csgsim::kinds
