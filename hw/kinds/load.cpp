#include "hw/kinds/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <span>

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
  const std::size_t end = machine.rfind(std::string(file_ending) + "+");
  return end == machine.npos ? std::string_view() : machine.substr(0, end + file_ending.size());
}

namespace {

const BuiltIn* built_in_named(std::string_view name) {
  const auto found =
      std::find_if(built_in().begin(), built_in().end(), [&](const BuiltIn& one) { return one.name == name; });
  return found == built_in().end() ? nullptr : &*found;
}

machines::Machine read(const BuiltIn& machine, std::span<const std::string> changes) {
  return machines::read_description(machine.text, fmt::format("{}.toml", machine.name), all(), changes);
}

/// Figures of the machine that are other than the original's, as its name tells them.
std::string edits(const machines::Machine& machine, const machines::Machine& original) {
  std::string text;
  for (const machines::Figure& figure : original.figures) {
    const auto found = std::find_if(machine.figures.begin(), machine.figures.end(),
                                    [&](const machines::Figure& one) { return one.key == figure.key; });
    if (found->value != figure.value) text += fmt::format("+{}={}", found->key, found->value);
  }
  return text;
}

machines::Machine read_file_of(const std::string& file, std::span<const std::string> changes) {
  const std::string text = read_file(file, machine_file);
  machines::Machine machine = machines::read_description(text, file, all(), changes);
  const std::string name = changes.empty() ? machine.name : machines::read_description(text, file, all()).name;
  const BuiltIn* const known = built_in_named(name);
  if (known == nullptr) return machine;
  const machines::Machine original = read(*known, {});
  if (machine.kind != original.kind) {
    throw InputError(
        fmt::format("{}: the name '{}' is that of a machine of another kind, which comes with csgsim; give "
                    "this one a name of its own",
                    file, name));
  }
  machine.name = name + edits(machine, original);
  return machine;
}

}  // namespace

machines::Machine load(const std::string& machine, const std::vector<std::string>& changes) {
  const std::string file(file_of(machine));
  const std::string name = file.empty() ? machine.substr(0, machine.find('+')) : file;
  std::vector<std::string> all_changes = changes_of(std::string_view(machine).substr(name.size()));
  all_changes.insert(all_changes.end(), changes.begin(), changes.end());
  if (!file.empty()) return read_file_of(file, all_changes);
  if (const BuiltIn* const found = built_in_named(name)) return read(*found, all_changes);
  throw InputError(no_such("machine", name, built_in_names()) + ", or a file, whose name ends in .toml");
}

}  // namespace csgsim::kinds
