// Comparison of the pixel states of two engines.
// Used by lockstep.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "sim/engine/engine.h"

namespace csgsim::lockstep {

/// A named quantity with different values on the two sides.
struct TwoValues {
  std::string name;  ///< name of the Program's field, or its position if it has none, or E
  std::uint64_t a = 0;
  std::uint64_t b = 0;

  bool operator==(const TwoValues&) const = default;
};

/// The differences at the first differing pixel, in row order.
struct PixelDifference {
  std::uint32_t x = 0;  ///< column in the picture
  std::uint32_t y = 0;
  std::vector<TwoValues> fields;  ///< E first, then in the order of the Program
  std::uint64_t pixels = 0;       ///< number of differing pixels

  bool operator==(const PixelDifference&) const = default;
};

/// Compares states of the same segment. Fields are named as in the Program `names`.
class StateComparison {
 public:
  /// For Programs with different numbers of memory bits, `memory_bits` is the number that both have.
  StateComparison(const isa::Program& names, std::uint32_t memory_bits);

  /// Compares E and all of memory.
  std::optional<PixelDifference> compare_all(const engine::PixelState& a, const engine::PixelState& b);

  /// Compares E and the fields of memory that an instruction can write.
  std::optional<PixelDifference> compare_written(const isa::Instruction& instruction, const engine::PixelState& a,
                                                 const engine::PixelState& b);

 private:
  struct Part {
    std::string name;
    isa::Field field;
  };

  std::optional<PixelDifference> compare(const std::vector<const Part*>& parts, const engine::PixelState& a,
                                         const engine::PixelState& b);
  void compare_enable(const engine::PixelState& a, const engine::PixelState& b);
  void compare_part(const Part& part, const engine::PixelState& a, const engine::PixelState& b);
  void read(const Part& part, const engine::PixelState& a, const engine::PixelState& b);

  std::vector<Part> parts_;  ///< together they cover all of memory
  std::vector<bool> differs_;
  std::vector<std::uint32_t> a_values_;
  std::vector<std::uint32_t> b_values_;
  std::vector<std::uint64_t> a_enable_;
  std::vector<std::uint64_t> b_enable_;
};

}  // namespace csgsim::lockstep
