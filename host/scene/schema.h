// Schema of scene files: sections and their keys.
// Used by manual.h, read.h, sections.cpp, host/emit and sim/session.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "host/scene/scene.h"
#include "host/scene/values.h"

namespace csgsim::scene {

/// A table of the scene file, or a list of tables of the same form. Each section has a struct for its tables and, next
/// to it, these functions:
/// - void visit_keys(Table& table, auto&& visit): calls visit(key, member) for each key, in order;
/// - void complete(Table& table), optional: completes the values read, and throws InputError, without a position, if
///   they are inconsistent.
struct Section {
  std::string_view name;  ///< for example `camera`, `effects.shadows`
  std::string_view meaning;
  bool is_list = false;
  Values (*blank)() = nullptr;  ///< returns the keys of a table with their default values
  /// Stores the values read from the file. Throws as complete() does.
  void (*keep)(Scene& scene, const Section& section, Values&& read) = nullptr;
};

inline constexpr double coordinate_limit = 1e9;  ///< limit of coordinates, in model units

constexpr Key boolean_key(std::string_view name, std::string_view meaning) {
  return {name, ValueKind::boolean, "", 0, 0, meaning};
}

constexpr Key integer_key(std::string_view name, std::string_view unit, double minimum, double maximum,
                          std::string_view meaning) {
  return {name, ValueKind::integer, unit, minimum, maximum, meaning};
}

constexpr Key number_key(std::string_view name, std::string_view unit, double minimum, double maximum,
                         std::string_view meaning) {
  return {name, ValueKind::number, unit, minimum, maximum, meaning};
}

constexpr Key vector_key(std::string_view name, std::string_view unit, std::string_view meaning) {
  return {name, ValueKind::vector, unit, -coordinate_limit, coordinate_limit, meaning};
}

constexpr Key colour_key(std::string_view name, std::string_view meaning) {
  return {name, ValueKind::colour, "", 0, 1, meaning};
}

constexpr Key colour_table_key(std::string_view name, std::string_view meaning) {
  return {name, ValueKind::colour_table, "", 0, 1, meaning};
}

constexpr Key choice_key(std::string_view name, std::span<const std::string_view> names, std::string_view meaning) {
  return {name, ValueKind::choice, "", 0, 0, meaning, names};
}

namespace detail {

/// The storage type of a section's tables: one struct, or a list of them.
template <class Kept>
struct TableOf {
  using type = Kept;
  static constexpr bool is_list = false;
};

template <class Entry>
struct TableOf<std::vector<Entry>> {
  using type = Entry;
  static constexpr bool is_list = true;
};

template <class Member>
void load(const Member& member, KeyValue& into) {
  if constexpr (requires { member.has_value(); }) {
    if (member) load(*member, into);
  } else if constexpr (std::is_class_v<Member>) {
    into.value = member;
  } else if (into.key.kind == ValueKind::boolean) {
    into.value = static_cast<bool>(member);
  } else if (into.key.kind == ValueKind::number) {
    into.value = static_cast<double>(member);
  } else {
    into.value = static_cast<std::int64_t>(member);
  }
}

template <class Member>
void store(const Value& value, Member& member) {
  if constexpr (requires { member.has_value(); }) {
    store(value, member.emplace());
  } else if constexpr (std::is_class_v<Member>) {
    member = std::get<Member>(value);
  } else {
    const auto put = [&](const auto& held) {
      if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(held)>>) member = static_cast<Member>(held);
    };
    std::visit(put, value);
  }
}

}  // namespace detail

template <class Table>
Values values_of(Table table) {
  Values values;
  visit_keys(table, [&](const Key& key, const auto& member) {
    values.push_back({key, {}});
    detail::load(member, values.back());
  });
  return values;
}

/// The default values of a table.
template <class Table>
Values blank_values() {
  return values_of(Table{});
}

/// The table with the given values, completed. Throws as complete() does.
template <class Table>
Table table_of(const Values& values) {
  Table table;
  std::size_t next = 0;
  visit_keys(table, [&](const Key& /*key*/, auto& member) {
    if (const std::optional<Value>& value = values[next++].value) detail::store(*value, member);
  });
  if constexpr (requires { complete(table); }) complete(table);
  return table;
}

/// Parses an effect's settings from its tables in the scene. Without tables these are the defaults. If Settings is a
/// std::vector, it has one element per table.
template <class Settings>
Settings settings_of(const std::vector<Values>& tables) {
  Settings settings;
  for (const Values& table : tables) {
    if constexpr (detail::TableOf<Settings>::is_list) {
      settings.push_back(table_of<typename Settings::value_type>(table));
    } else {
      settings = table_of<Settings>(table);
    }
  }
  return settings;
}

/// A section stored in a member of the scene; a list section if the member is a std::vector.
template <class Kept, Kept Scene::*member>
constexpr Section section(std::string_view name, std::string_view meaning) {
  using Table = typename detail::TableOf<Kept>::type;
  return {name, meaning, detail::TableOf<Kept>::is_list, blank_values<Table>,
          [](Scene& scene, const Section& /*section*/, Values&& read) {
            if constexpr (detail::TableOf<Kept>::is_list) {
              (scene.*member).push_back(table_of<Table>(read));
            } else {
              scene.*member = table_of<Table>(read);
            }
          }};
}

/// Adds a table of an effect to the scene. For a list section, this adds one more entry.
void add_effect_table(Scene& scene, const Section& section, Values&& table);

/// The section of an effect, whose tables are added to the scene; a list section if Settings is a std::vector.
template <class Settings>
constexpr Section effect_section(std::string_view name, std::string_view meaning) {
  using Table = typename detail::TableOf<Settings>::type;
  return {name, meaning, detail::TableOf<Settings>::is_list, blank_values<Table>,
          [](Scene& scene, const Section& section, Values&& read) {
            table_of<Table>(read);  // validates: throws if the values are inconsistent
            add_effect_table(scene, section, std::move(read));
          }};
}

inline constexpr double last_line = 4'294'967'295.0;

/// The keys that select primitives. For sections whose table is derived from PrimitiveSelection.
void visit_keys(PrimitiveSelection& chosen, auto&& visit) {
  visit(colour_key("of_colour", "selects primitives with this colour in the model"), chosen.of_colour);
  visit(integer_key("from_line", "", 1, last_line, "selects primitives from this line of the model on"),
        chosen.from_line);
  visit(integer_key("to_line", "", 1, last_line, "last line; defaults to from_line"), chosen.to_line);
}

/// Completes the line range. Throws InputError if it is invalid.
void complete(PrimitiveSelection& chosen);

/// The sections camera, background, ambient, lights and materials.
std::span<const Section> common_sections();

}  // namespace csgsim::scene
