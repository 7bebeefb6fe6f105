#pragma once

#include <any>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "host/scene/scene.h"

namespace csgsim::scene {

/// Rows of colours, all of one length.
using ColourTable = std::vector<std::vector<glm::dvec3>>;

/// A value of a scene file; a choice is the number of its name.
using Value = std::variant<bool, std::int64_t, double, glm::dvec3, ColourTable>;

enum class ValueKind : std::uint8_t {
  boolean,
  integer,
  number,
  vector,        ///< three numbers
  colour,        ///< three numbers from 0 to 1
  colour_table,  ///< a list of rows, each a list of colours
  choice,        ///< one of `names`
};

/// One key of a section.
struct Key {
  std::string_view name;
  ValueKind kind = ValueKind::boolean;
  std::string_view unit;  ///< empty for what has none
  double least = 0;       ///< of an integer or number, or of each of a vector's
  double most = 0;
  std::string_view meaning;
  void (*store)(std::any& section, const Value& value) = nullptr;
  std::span<const std::string_view> names{};
  /// The value in a section; nothing where none is said.
  std::optional<Value> (*load)(const std::any& section) = nullptr;
};

/// A table of the scene file, or a list of tables of the same form.
struct Section {
  std::string_view name;  ///< as in `[camera]`, `[effects.shadows]`
  std::string_view meaning;
  bool is_list = false;
  std::span<const Key> keys;
  std::any (*blank)() = nullptr;
  /// Takes what was read. Throws InputError, without a place, where the values do not fit each other.
  void (*keep)(Scene& scene, const Section& section, std::any&& read) = nullptr;
};

inline constexpr double any_number = 1e9;  ///< bound of coordinates, model units

namespace detail {

template <class Member>
struct OfMember;

template <class Struct, class Type>
struct OfMember<Type Struct::*> {
  using struct_type = Struct;
  using type = Type;
};

template <class Type>
struct Plain {
  using type = Type;
};

template <class Type>
struct Plain<std::optional<Type>> {
  using type = Type;
};

/// Into a member of the section, or into a member of that member, and so on.
template <class Of, class Held, auto... path>
void store_in(std::any& section, const Value& value) {
  auto& target = ((std::any_cast<Of&>(section)).*....*path);
  using Wanted = typename Plain<std::remove_reference_t<decltype(target)>>::type;
  target = static_cast<Wanted>(std::get<Held>(value));
}

/// The section that the first of the members is of. It has to be an argument of the templates above by name: g++ 12
/// takes functions that differ only in members of unnamed namespaces for one.
template <auto member, auto...>
struct SectionOf {
  using type = typename OfMember<decltype(member)>::struct_type;
};

template <class Of, class Held, auto... path>
std::optional<Value> load_from(const std::any& section) {
  const auto& value = ((std::any_cast<const Of&>(section)).*....*path);
  if constexpr (requires { value.has_value(); }) {
    if (!value) return std::nullopt;
    return Value(static_cast<Held>(*value));
  } else {
    return Value(static_cast<Held>(value));
  }
}

}  // namespace detail

template <auto... member>
constexpr Key boolean_key(std::string_view name, std::string_view meaning) {
  return {name,
          ValueKind::boolean,
          "",
          0,
          0,
          meaning,
          detail::store_in<typename detail::SectionOf<member...>::type, bool, member...>,
          {},
          detail::load_from<typename detail::SectionOf<member...>::type, bool, member...>};
}

template <auto... member>
constexpr Key integer_key(std::string_view name, std::string_view unit, double least, double most,
                          std::string_view meaning) {
  return {name,
          ValueKind::integer,
          unit,
          least,
          most,
          meaning,
          detail::store_in<typename detail::SectionOf<member...>::type, std::int64_t, member...>,
          {},
          detail::load_from<typename detail::SectionOf<member...>::type, std::int64_t, member...>};
}

template <auto... member>
constexpr Key number_key(std::string_view name, std::string_view unit, double least, double most,
                         std::string_view meaning) {
  return {name,
          ValueKind::number,
          unit,
          least,
          most,
          meaning,
          detail::store_in<typename detail::SectionOf<member...>::type, double, member...>,
          {},
          detail::load_from<typename detail::SectionOf<member...>::type, double, member...>};
}

template <auto... member>
constexpr Key vector_key(std::string_view name, std::string_view unit, std::string_view meaning) {
  return {name,
          ValueKind::vector,
          unit,
          -any_number,
          any_number,
          meaning,
          detail::store_in<typename detail::SectionOf<member...>::type, glm::dvec3, member...>,
          {},
          detail::load_from<typename detail::SectionOf<member...>::type, glm::dvec3, member...>};
}

template <auto... member>
constexpr Key colour_key(std::string_view name, std::string_view meaning) {
  return {name,
          ValueKind::colour,
          "",
          0,
          1,
          meaning,
          detail::store_in<typename detail::SectionOf<member...>::type, glm::dvec3, member...>,
          {},
          detail::load_from<typename detail::SectionOf<member...>::type, glm::dvec3, member...>};
}

template <auto... member>
constexpr Key colour_table_key(std::string_view name, std::string_view meaning) {
  return {name,
          ValueKind::colour_table,
          "",
          0,
          1,
          meaning,
          detail::store_in<typename detail::SectionOf<member...>::type, ColourTable, member...>,
          {},
          detail::load_from<typename detail::SectionOf<member...>::type, ColourTable, member...>};
}

template <auto... member>
constexpr Key choice_key(std::string_view name, std::span<const std::string_view> names, std::string_view meaning) {
  return {name,
          ValueKind::choice,
          "",
          0,
          0,
          meaning,
          detail::store_in<typename detail::SectionOf<member...>::type, std::int64_t, member...>,
          names,
          detail::load_from<typename detail::SectionOf<member...>::type, std::int64_t, member...>};
}

template <class Settings>
std::any blank_section() {
  return Settings{};
}

/// `keep` of an effect: the scene calls for it.
void keep_effect(Scene& scene, const Section& section, std::any&& read);

/// `keep` of an effect whose section is a list of tables, each an Entry: its settings are a std::vector<Entry>.
template <class Entry>
void keep_entry(Scene& scene, const Section& section, std::any&& read) {
  if (scene.effects.empty() || scene.effects.back().name != section.name)
    scene.effects.push_back({section.name, std::vector<Entry>{}});
  std::any_cast<std::vector<Entry>&>(scene.effects.back().settings).push_back(std::any_cast<Entry&&>(std::move(read)));
}

inline constexpr double last_line = 4'294'967'295.0;

/// The keys that choose primitives, of a section that is a Chosen.
template <class Of>
inline constexpr std::array chosen_keys{Key{"of_colour",
                                            ValueKind::colour,
                                            "",
                                            0,
                                            1,
                                            "for the primitives that have this colour in the model",
                                            detail::store_in<Of, glm::dvec3, &Chosen::of_colour>,
                                            {},
                                            detail::load_from<Of, glm::dvec3, &Chosen::of_colour>},
                                        Key{"from_line",
                                            ValueKind::integer,
                                            "",
                                            1,
                                            last_line,
                                            "for those from this line of the model on",
                                            detail::store_in<Of, std::int64_t, &Chosen::from_line>,
                                            {},
                                            detail::load_from<Of, std::int64_t, &Chosen::from_line>},
                                        Key{"to_line",
                                            ValueKind::integer,
                                            "",
                                            1,
                                            last_line,
                                            "to this line; from_line if not given",
                                            detail::store_in<Of, std::int64_t, &Chosen::to_line>,
                                            {},
                                            detail::load_from<Of, std::int64_t, &Chosen::to_line>}};

/// Completes what was read. Throws InputError where the lines are none.
void complete(Chosen& chosen);

/// Keys of two kinds in one list.
template <std::size_t m, std::size_t n>
constexpr std::array<Key, m + n> joined(const std::array<Key, m>& first, const std::array<Key, n>& second) {
  std::array<Key, m + n> all{};
  for (std::size_t i = 0; i < m; ++i) all[i] = first[i];
  for (std::size_t i = 0; i < n; ++i) all[m + i] = second[i];
  return all;
}

/// camera, background, ambient, lights, materials.
std::span<const Section> common_sections();

}  // namespace csgsim::scene
