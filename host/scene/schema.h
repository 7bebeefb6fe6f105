#pragma once

#include <any>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <variant>

#include "host/scene/scene.h"

namespace csgsim::scene {

/// A value of a scene file; a choice is the number of its name.
using Value = std::variant<bool, std::int64_t, double, glm::dvec3>;

enum class ValueKind : std::uint8_t {
  boolean,
  integer,
  number,
  vector,  ///< three numbers
  colour,  ///< three numbers from 0 to 1
  choice,  ///< one of `names`
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

template <auto member, class Held>
void store(std::any& section, const Value& value) {
  using Of = OfMember<decltype(member)>;
  using Wanted = typename Plain<typename Of::type>::type;
  std::any_cast<typename Of::struct_type&>(section).*member = static_cast<Wanted>(std::get<Held>(value));
}

template <auto member, class Held>
std::optional<Value> load(const std::any& section) {
  using Of = OfMember<decltype(member)>;
  const auto& value = std::any_cast<const typename Of::struct_type&>(section).*member;
  if constexpr (requires { value.has_value(); }) {
    if (!value) return std::nullopt;
    return Value(static_cast<Held>(*value));
  } else {
    return Value(static_cast<Held>(value));
  }
}

}  // namespace detail

template <auto member>
constexpr Key boolean_key(std::string_view name, std::string_view meaning) {
  return {name, ValueKind::boolean, "", 0, 0, meaning, detail::store<member, bool>, {}, detail::load<member, bool>};
}

template <auto member>
constexpr Key integer_key(std::string_view name, std::string_view unit, double least, double most,
                          std::string_view meaning) {
  return {name,
          ValueKind::integer,
          unit,
          least,
          most,
          meaning,
          detail::store<member, std::int64_t>,
          {},
          detail::load<member, std::int64_t>};
}

template <auto member>
constexpr Key number_key(std::string_view name, std::string_view unit, double least, double most,
                         std::string_view meaning) {
  return {name, ValueKind::number,           unit, least, most, meaning, detail::store<member, double>,
          {},   detail::load<member, double>};
}

template <auto member>
constexpr Key vector_key(std::string_view name, std::string_view unit, std::string_view meaning) {
  return {name,
          ValueKind::vector,
          unit,
          -any_number,
          any_number,
          meaning,
          detail::store<member, glm::dvec3>,
          {},
          detail::load<member, glm::dvec3>};
}

template <auto member>
constexpr Key colour_key(std::string_view name, std::string_view meaning) {
  return {name,
          ValueKind::colour,
          "",
          0,
          1,
          meaning,
          detail::store<member, glm::dvec3>,
          {},
          detail::load<member, glm::dvec3>};
}

template <auto member>
constexpr Key choice_key(std::string_view name, std::span<const std::string_view> names, std::string_view meaning) {
  return {name,
          ValueKind::choice,
          "",
          0,
          0,
          meaning,
          detail::store<member, std::int64_t>,
          names,
          detail::load<member, std::int64_t>};
}

template <class Settings>
std::any blank_section() {
  return Settings{};
}

/// `keep` of an effect: the scene calls for it.
void keep_effect(Scene& scene, const Section& section, std::any&& read);

/// camera, background, ambient, lights, materials.
std::span<const Section> common_sections();

}  // namespace csgsim::scene
