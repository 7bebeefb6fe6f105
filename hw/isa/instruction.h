// Fields, linear expressions, origins and instructions.
// Used by hw, host/emit, sim/cycle, sim/functional, sim/session and sim/studies.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "hw/isa/opcode.h"

namespace csgsim::isa {

inline constexpr unsigned max_field_width = 32;        ///< bits
inline constexpr unsigned max_wide_field_width = 62;   ///< bits, for opcodes with allows_wide_fields()
inline constexpr unsigned max_linear_width = 62;       ///< bits streamed by the linear expression evaluator
inline constexpr unsigned max_memory_bits = 4096;      ///< bits per pixel
inline constexpr unsigned max_count = 0xffffffffU;     ///< instructions skipped by one skip_if_none
inline constexpr unsigned max_array_side = 1U << 14U;  ///< pixels

/// `width` consecutive bits of pixel memory with the least significant bit at `base`.
struct Field {
  std::uint16_t base = 0;
  std::uint16_t width = 0;

  [[nodiscard]] constexpr unsigned end() const { return static_cast<unsigned>(base) + width; }
  [[nodiscard]] constexpr bool overlaps(Field other) const { return base < other.end() && other.base < end(); }
  constexpr bool operator==(const Field&) const = default;
};

/// A*x + B*y + C, streamed over `width` bits, least significant first; the low `shift` bits are the fraction. F has
/// width - shift bits.
struct Linear {
  std::int64_t a = 0;
  std::int64_t b = 0;
  std::int64_t c = 0;
  std::uint16_t width = 0;
  std::uint16_t shift = 0;

  constexpr bool operator==(const Linear&) const = default;
};

/// The reason why an instruction is broadcast.
#define CSGSIM_PURPOSES(P)                                         \
  P(setup, "clear the frame: background depth and colour")         \
  P(render, "a primitive's visible surface into Z1")               \
  P(classify, "a primitive of an active tree compared with Z1")    \
  P(stack, "combine classifications by the operators of the tree") \
  P(merge, "depth test against Z2 and copy of the nearer surface") \
  P(shade, "colour of the facets that were merged")                \
  P(effect, "work of an effect that belongs to no surface")

enum class Purpose : std::uint8_t {
#define CSGSIM_PURPOSE_ENUMERATOR(name, meaning) name,
  CSGSIM_PURPOSES(CSGSIM_PURPOSE_ENUMERATOR)
#undef CSGSIM_PURPOSE_ENUMERATOR
};

struct PurposeInfo {
  std::string_view name;
  std::string_view meaning;
};

inline constexpr auto purpose_table = std::to_array<PurposeInfo>({
#define CSGSIM_PURPOSE_ROW(name, meaning) PurposeInfo{#name, meaning},
    CSGSIM_PURPOSES(CSGSIM_PURPOSE_ROW)
#undef CSGSIM_PURPOSE_ROW
});

constexpr const PurposeInfo& info(Purpose purpose) { return purpose_table[static_cast<std::size_t>(purpose)]; }

inline constexpr std::uint32_t no_primitive = 0xffffffffU;
inline constexpr std::uint32_t no_node = 0xffffffffU;
inline constexpr std::uint8_t no_effect = 0xffU;

/// What an instruction is for. Statistics and waves show it; machines ignore it.
struct Origin {
  Purpose purpose = Purpose::setup;
  std::uint32_t primitive = no_primitive;  ///< number of the piece (hw/isa/pieces.h) whose surface is drawn
  /// Piece compared with the surface during classification; for merging and shading a solid drawn in several pieces,
  /// its first piece; otherwise no_node.
  std::uint32_t node = no_node;
  std::uint8_t effect = no_effect;  ///< index into CompileFacts::effects of the effect it is charged to, or no_effect

  constexpr bool operator==(const Origin&) const = default;
};

/// One broadcast instruction. Operand i of the opcode's row is fields[i] if it is a target or source, `linear` if it is
/// a linear expression or squares, and `constant` if it is a constant or a count. Members that the row does not use are
/// zero. Squares store the coefficients of x*x, x*y and y*y in a, b and c, and have shift 0.
struct Instruction {
  Opcode opcode{};  ///< enable_all
  std::array<Field, max_operands> fields{};
  Linear linear{};
  std::uint64_t constant = 0;
  Origin origin{};

  constexpr bool operator==(const Instruction&) const = default;
};

}  // namespace csgsim::isa
