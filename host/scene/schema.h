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

/// A table of the scene file, or a list of tables of the same form. Whoever has a section has a struct for its tables,
/// and beside it
///   void visit_keys(Table& table, auto&& visit): calls visit(key, member) for each key, in order;
///   void complete(Table& table), if there is something to do: completes what was read, and throws InputError, without
///   a place, where the values do not fit each other.
struct Section {
  std::string_view name;  ///< as in `[camera]`, `[effects.shadows]`
  std::string_view meaning;
  bool is_list = false;
  Values (*blank)() = nullptr;
  /// Takes what was read. Throws as complete does.
  void (*keep)(Scene& scene, const Section& section, Values&& read) = nullptr;
};

inline constexpr double any_number = 1e9;  ///< bound of coordinates, model units

constexpr Key boolean_key(std::string_view name, std::string_view meaning) {
  return {name, ValueKind::boolean, "", 0, 0, meaning};
}

constexpr Key integer_key(std::string_view name, std::string_view unit, double least, double most,
                          std::string_view meaning) {
  return {name, ValueKind::integer, unit, least, most, meaning};
}

constexpr Key number_key(std::string_view name, std::string_view unit, double least, double most,
                         std::string_view meaning) {
  return {name, ValueKind::number, unit, least, most, meaning};
}

constexpr Key vector_key(std::string_view name, std::string_view unit, std::string_view meaning) {
  return {name, ValueKind::vector, unit, -any_number, any_number, meaning};
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

/// What a section's tables are kept in: one struct, or a list of them.
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

/// The values of a table that says nothing.
template <class Table>
Values blank_values() {
  return values_of(Table{});
}

/// The table with these values, complete. Throws as complete does.
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

/// The tables that a scene has of an effect, as its settings: the defaults where it has none, or a std::vector of all.
template <class Settings>
Settings settings_of(const std::vector<Values>& tables) {
  Settings settings;
  for (const Values& one : tables) {
    if constexpr (detail::TableOf<Settings>::is_list) {
      settings.push_back(table_of<typename Settings::value_type>(one));
    } else {
      settings = table_of<Settings>(one);
    }
  }
  return settings;
}

/// A section that is kept in a member of the scene; a list, if that is one.
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

/// Has the scene call for an effect with this table, which is one more where the section is a list.
void call(Scene& scene, const Section& section, Values&& table);

/// Of an effect, for which the scene calls with it; a list, if the settings are a std::vector.
template <class Settings>
constexpr Section effect_section(std::string_view name, std::string_view meaning) {
  using Table = typename detail::TableOf<Settings>::type;
  return {name, meaning, detail::TableOf<Settings>::is_list, blank_values<Table>,
          [](Scene& scene, const Section& section, Values&& read) {
            table_of<Table>(read);  // throws where the values do not fit each other
            call(scene, section, std::move(read));
          }};
}

inline constexpr double last_line = 4'294'967'295.0;

/// The keys that choose primitives, of a section whose table is a Chosen.
void visit_keys(Chosen& chosen, auto&& visit) {
  visit(colour_key("of_colour", "for the primitives that have this colour in the model"), chosen.of_colour);
  visit(integer_key("from_line", "", 1, last_line, "for those from this line of the model on"), chosen.from_line);
  visit(integer_key("to_line", "", 1, last_line, "to this line; from_line if not given"), chosen.to_line);
}

/// Completes what was read. Throws InputError where the lines are none.
void complete(Chosen& chosen);

/// camera, background, ambient, lights, materials.
std::span<const Section> common_sections();

}  // namespace csgsim::scene
