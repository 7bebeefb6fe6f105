#include "sim/session/options/sets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "host/scene/schema.h"
#include "hw/base/nearest.h"
#include "hw/kinds/load.h"
#include "hw/kinds/parameters.h"
#include "hw/kinds/rows.h"
#include "hw/machines/description.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/suggestions.h"
#include "sim/session/options/usage.h"

namespace csgsim::session {

namespace {

using kinds::key_of;

std::string_view first_word(std::string_view key) { return key.substr(0, key.find('.')); }

/// Checks the first word only; the scene's reader checks the rest of the key.
bool is_of_scene(std::string_view key) {
  const std::string_view word = first_word(key);
  return word == "effects" || std::ranges::any_of(scene::common_sections(),
                                                  [&](const scene::Section& section) { return section.name == word; });
}

/// Rejects a text without key or value.
void refuse_form(const std::string& set) {
  const std::string option = "--set " + set;
  if (key_of(set).empty()) throw UsageError(option, "there is no key before '='; write KEY=VALUE, as in alu.bits=4");
  if (set.find('=') == set.npos)
    throw UsageError(option, fmt::format("'{}' is not of the form KEY=VALUE, as in alu.bits=4", set));
}

[[noreturn]] void fail_unknown(const std::string& set) {
  const std::string_view key = key_of(set);
  const std::string option = "--set " + set;
  if (is_option_name(key)) throw UsageError(option, fmt::format("{0} is an option and no key; write --{0} VALUE", key));
  const std::vector<std::string> near = suggested_keys(key);
  throw UsageError(option, fmt::format("'{}' is neither a machine parameter nor a scene key; {}", key,
                                       near.empty() ? "csgsim manual machines NAME and csgsim manual scenes list them"
                                                    : fmt::format("did you mean {}?", alternatives_text(near))));
}

}  // namespace

Sets divide_settings(const std::vector<std::string>& settings) {
  Sets all;
  for (const std::string& set : settings) {
    refuse_form(set);
    if (kinds::is_parameter(key_of(set))) {
      all.figures.push_back(set);
    } else if (is_of_scene(key_of(set))) {
      all.scene.push_back(set);
    } else {
      fail_unknown(set);
    }
  }
  return all;
}

void check_machine(const std::string& name) {
  const std::vector<std::string_view> known = kinds::built_in_names();
  if (kinds::file_of(name).empty() && std::ranges::find(known, name) == known.end()) kinds::load(name);
}

void check_machines(const std::string& names) {
  for (const std::string& name : parse_words(names)) check_machine(name);
}

namespace {

template <class Source>
machines::Machine load_from(const Source& source, const std::string& name, const std::vector<std::string>& sets) {
  const std::vector<std::string> figures = divide_settings(sets).figures;
  machines::Machine plain = kinds::load(source);
  if (figures.empty()) return plain;
  for (const std::string& figure : figures) {
    const std::string reason = kinds::missing_parameter_text(key_of(figure), *plain.kind, name);
    if (!reason.empty()) throw UsageError("--set " + figure, reason);
  }
  try {
    return kinds::load(source, figures);
  } catch (const machines::ChangeError& error) {
    throw UsageError("--set", error.what());
  }
}

}  // namespace

machines::Machine load_machine(const std::string& name, const std::vector<std::string>& settings) {
  return load_from(name, name, settings);
}

machines::Machine load_machine(const isa::MachineRecord& record, const std::vector<std::string>& settings) {
  return load_from(record, record.name, settings);
}

std::vector<std::string> with_parameters(const std::vector<std::string>& names,
                                         const std::vector<std::string>& settings) {
  const std::vector<std::string> figures = divide_settings(settings).figures;
  if (figures.empty()) return names;
  std::vector<std::string> edited;
  std::set<std::string> taken;
  for (const std::string& name : names) {
    const machines::Machine plain = kinds::load(name);
    std::vector<std::string> own;
    for (const std::string& figure : figures) {
      if (!kinds::has_parameter(*plain.kind, key_of(figure))) continue;
      own.push_back(figure);
      taken.insert(figure);
    }
    load_machine(name, own);  // reports an invalid value as an error of --set
    edited.push_back(own.empty() ? name : fmt::format("{}+{}", name, fmt::join(own, "+")));
  }
  for (const std::string& figure : figures) {
    if (!taken.contains(figure))
      throw UsageError("--set " + figure, fmt::format("none of {} has that parameter; machines of the kind {} have it",
                                                      fmt::format("{}", fmt::join(names, ", ")),
                                                      kinds::names_of_kinds_with(key_of(figure))));
  }
  return edited;
}

void add_parameter_sets(OptionList& command, std::vector<std::string>& settings, const std::string& machine) {
  command.option("--set", settings, "A parameter of " + machine + ", as in alu.bits=4; repeat for several");
}

void refuse_scene_sets(const std::vector<std::string>& settings, const std::string& option) {
  const std::vector<std::string> of_scene = divide_settings(settings).scene;
  if (!of_scene.empty())
    throw UsageError(option, "'" + of_scene.front() +
                                 "' is a key of a scene, which has no effect here; only machine parameters can be set");
}

}  // namespace csgsim::session
