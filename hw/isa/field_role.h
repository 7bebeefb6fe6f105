// Roles and names of fields of pixel memory.
// Used by hw/isa, host/emit, host/effects and sim/story.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "hw/isa/instruction.h"

namespace csgsim::isa {

/// The content of a field of pixel memory, for pictures, statistics and waves. The first list contains the roles in use
/// while surfaces are drawn, the second all roles.
#define CSGSIM_SURFACE_ROLES(R) \
  R(scratch) R(candidate_depth) R(depth) R(colour) R(candidate_colour) R(mask) R(stack) R(product) R(label) R(stored)
#define CSGSIM_FIELD_ROLES(R) CSGSIM_SURFACE_ROLES(R) R(shown) R(owner) R(effect)

enum class FieldRole : std::uint8_t {
#define CSGSIM_FIELD_ROLE_ENUMERATOR(name) name,
  CSGSIM_FIELD_ROLES(CSGSIM_FIELD_ROLE_ENUMERATOR)
#undef CSGSIM_FIELD_ROLE_ENUMERATOR
};

inline constexpr auto field_role_names = std::to_array<std::string_view>({
#define CSGSIM_FIELD_ROLE_NAME(name) #name,
    CSGSIM_FIELD_ROLES(CSGSIM_FIELD_ROLE_NAME)
#undef CSGSIM_FIELD_ROLE_NAME
});

constexpr std::string_view name_of(FieldRole role) { return field_role_names[static_cast<std::size_t>(role)]; }

struct NamedField {
  std::string name;
  Field field;
  FieldRole role = FieldRole::scratch;

  bool operator==(const NamedField&) const = default;
};

}  // namespace csgsim::isa
