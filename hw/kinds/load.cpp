#include "hw/kinds/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <span>

#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/nearest.h"
#include "hw/base/text.h"
#include "hw/kinds/parameters.h"
#include "hw/kinds/rows.h"
#include "hw/machines/description.h"

namespace csgsim::kinds {

using machines::BuiltIn;

namespace {

constexpr InputKind machine_file{"a machine file, which ends in .toml", std::size_t{1} << 20U,
                                 "a machine file is much shorter"};

}  // namespace

std::vector<std::string_view> built_in_names() {
  std::vector<std::string_view> names;
  for (const BuiltIn& machine : built_in()) names.push_back(machine.name);
  return names;
}

namespace {

const BuiltIn* built_in_named(std::string_view name) {
  const auto found =
      std::find_if(built_in().begin(), built_in().end(), [&](const BuiltIn& one) { return one.name == name; });
  return found == built_in().end() ? nullptr : &*found;
}

machines::Machine read(const BuiltIn& machine, std::span<const std::string> changes) {
  return machines::read_description(machine.text, machine.name, all(), changes);
}

machines::Machine load_file(const std::string& file, std::span<const std::string> changes) {
  const std::string text = read_file(file, machine_file);
  machines::Machine machine = machines::read_description(text, file, all(), changes);
  const std::string name = changes.empty() ? machine.name : machines::read_description(text, file, all()).name;
  const BuiltIn* const known = built_in_named(name);
  if (known == nullptr) return machine;
  const machines::Machine original = read(*known, {});
  if (machine.kind != original.kind) {
    throw InputError(
        fmt::format("{}: '{}' is the name of a built-in machine of another kind; give this machine another "
                    "name",
                    file, name));
  }
  machine.name = name + machines::edits_suffix(machine.figures, original.figures);
  return machine;
}

}  // namespace

// Runs at every start. It searches the texts, because parsing nine descriptions would quadruple the start-up time.
std::vector<std::string_view> studied_names() {
  const auto is_costly = [](std::string_view name) {
    const BuiltIn& machine = *built_in_named(name);
    return std::ranges::any_of(all(), [&](const machines::Kind* kind) {
      return kind->is_costly() && machine.text.find(fmt::format("\nkind = \"{}\"\n", kind->name)) != machine.text.npos;
    });
  };
  std::vector<std::string_view> names = built_in_names();
  std::erase_if(names, is_costly);
  return names;
}

namespace {

/// The figures of the record that differ from the machine's.
std::vector<std::string> figure_differences(const isa::MachineRecord& record, const machines::Machine& machine) {
  std::vector<std::string> others;
  for (const std::string& recorded : record.figures) {
    const auto same = [&](const machines::Figure& one) { return recorded == one.key + "=" + one.value; };
    if (std::none_of(machine.figures.begin(), machine.figures.end(), same)) others.push_back(recorded);
  }
  return others;
}

machines::Machine read_built_in(const BuiltIn& known, const isa::MachineRecord& record,
                                const std::vector<std::string>& changes) {
  std::vector<std::string> all_changes = machines::changes_of(record.name);
  machines::Machine machine = read(known, all_changes);
  if (!record.kind.empty() && record.kind != machine.kind->name) {
    throw InputError(
        fmt::format("the Program was compiled for a machine '{}' of the kind {}, which is of the kind {} here; choose "
                    "a machine with --machine",
                    record.name, machine.kind->name, record.kind));
  }
  const std::vector<std::string> others = figure_differences(record, machine);
  all_changes.insert(all_changes.end(), others.begin(), others.end());
  all_changes.insert(all_changes.end(), changes.begin(), changes.end());
  return read(known, all_changes);
}

/// Builds a machine that is not built in from a built-in machine of its kind, by replacing all parameters.
machines::Machine read_foreign(const isa::MachineRecord& record, const std::vector<std::string>& changes) {
  const auto of_kind = [&](const BuiltIn& one) { return read(one, {}).kind->name == record.kind; };
  const auto other = std::find_if(built_in().begin(), built_in().end(), of_kind);
  if (other == built_in().end())
    throw InputError(unknown_name_text("machine", record.name, built_in_names()) + "; choose one with --machine");
  std::vector<std::string> all_changes = record.figures;
  for (const machines::Figure& figure : read(*other, {}).figures) {
    const bool is_recorded = std::any_of(record.figures.begin(), record.figures.end(),
                                         [&](const std::string& recorded) { return key_of(recorded) == figure.key; });
    if (!is_recorded) {
      throw InputError(fmt::format("the parameter {} of the machine '{}' is missing; choose a machine with --machine",
                                   figure.key, record.name));
    }
  }
  all_changes.insert(all_changes.end(), changes.begin(), changes.end());
  machines::Machine machine = read(*other, all_changes);
  machine.name = printable(record.name);
  for (const std::string& change : changes) machine.name += "+" + printable(change);
  machine.description = "a machine that a Program was compiled for";
  return machine;
}

}  // namespace

machines::Machine load(const isa::MachineRecord& record, const std::vector<std::string>& changes) {
  const BuiltIn* const known = built_in_named(machines::base_name(record.name));
  return known == nullptr ? read_foreign(record, changes) : read_built_in(*known, record, changes);
}

machines::Machine load(const std::string& machine, const std::vector<std::string>& changes) {
  const std::string name(machines::base_name(machine));
  std::vector<std::string> all_changes = machines::changes_of(machine);
  all_changes.insert(all_changes.end(), changes.begin(), changes.end());
  if (!file_of(machine).empty()) return load_file(name, all_changes);
  if (const BuiltIn* const found = built_in_named(name)) return read(*found, all_changes);
  throw InputError(unknown_name_text("machine", name, built_in_names()) +
                   "; the name of a machine file must end in .toml");
}

}  // namespace csgsim::kinds
