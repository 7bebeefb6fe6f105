#pragma once

#include <cstdint>

#include "tests/m68000/processor.h"
#include "tests/m68000/tree.h"

namespace csgsim::m68000 {

/// Methods of the thesis, sections 4.3 and 4.4.
enum class Method : std::uint8_t { standard, early_out, status_tree, bit_parallel, positional };

/// How the program of a method was written.
enum class Written : std::uint8_t {
  by_hand,             ///< assembly, programs.s
  compiled_plainly,    ///< C, compiled/methods.c, by GCC with -O0: variables stay in memory
  compiled_optimised,  ///< the same with -O1
};

/// Addresses of a program's subroutines and tables.
struct Program;

/// A processor with a tree in its memory, which classifies points on a ray with the program of a method.
class M68000Traversal {
 public:
  explicit M68000Traversal(Method method, Written written = Written::by_hand);

  /// Writes the tree to memory; the ray starts outside every primitive. Throws std::out_of_range for a tree too large
  /// for the method: more than 1024 primitives, or for bits more than five levels (developed_tree.h).
  void load(const Tree& tree);

  /// Passes a surface of the primitive: inverts its status and updates a status tree.
  void flip(std::uint16_t primitive);

  /// Whether the ray is inside the composite object: evaluates the tree, or reads the root of a status tree.
  bool evaluate();

  /// Clocks of all flips and evaluations since the tree was loaded: from the first instruction of each to its RTS,
  /// without those of its caller.
  [[nodiscard]] std::uint64_t clocks() const { return clocks_; }

  /// Clocks of the last flip or evaluation.
  [[nodiscard]] std::uint64_t last_clocks() const { return last_clocks_; }

 private:
  void put_nodes(const Tree& tree);
  /// Assigns codes to the leaves in order, starting with `first`; returns the code after the node's last.
  std::uint32_t put_codes(const Tree& tree, std::size_t index, std::uint32_t first);
  void put_levels(const Tree& tree);
  void call(std::uint32_t address, std::uint32_t argument);

  Method method_;
  Written written_;
  const Program& program_;
  Processor processor_;
  std::uint64_t clocks_ = 0;
  std::uint64_t last_clocks_ = 0;
  std::uint32_t object_ = 0;  ///< address of the root or of the levels
};

}  // namespace csgsim::m68000
