#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tests/m68000/processor.h"

namespace csgsim::m68000 {

/// What a node is; programs have the same numbers.
enum class NodeKind : std::uint16_t { primitive, set_union, difference, intersection };

struct TreeNode {
  NodeKind kind = NodeKind::primitive;
  std::uint16_t primitive = 0;  ///< number of a leaf's, from 0; every primitive has one leaf
  std::size_t left = 0;         ///< index of the node, of one that is no leaf
  std::size_t right = 0;
};

/// Of 1024 primitives at most.
struct Tree {
  std::vector<TreeNode> nodes;
  std::size_t root = 0;
};

/// Methods of the thesis, section 4.3.
enum class Method : std::uint8_t { standard, early_out, status_tree };

/// How the program of a method was written.
enum class Written : std::uint8_t {
  by_hand,             ///< in assembly, programs.s
  compiled_plainly,    ///< in C, compiled/methods.c, by GCC with -O0: variables stay in memory
  compiled_optimised,  ///< the same with -O1
};

/// Where a program has what it needs, by address.
struct Program;

/// A processor with a tree in its memory, which classifies points on a ray by the program of a method.
class M68000Traversal {
 public:
  explicit M68000Traversal(Method method, Written written = Written::by_hand);

  /// Puts the tree into memory; the ray is out of every primitive.
  void load(const Tree& tree);

  /// The ray goes through a surface of the primitive: its status is inverted, and a status tree is brought up to date.
  void flip(std::uint16_t primitive);

  /// Whether the ray is in the composite object: works it out, or, of a status tree, looks at its root.
  bool evaluate();

  /// Clocks of all flips and evaluations since the tree was loaded: from the first instruction of each to its RTS,
  /// without those of its caller.
  [[nodiscard]] std::uint64_t clocks() const { return clocks_; }

  /// Of the last of them.
  [[nodiscard]] std::uint64_t last_clocks() const { return last_clocks_; }

 private:
  void call(std::uint32_t address, std::uint32_t argument);

  Method method_;
  Written written_;
  const Program& program_;
  Processor processor_;
  std::uint64_t clocks_ = 0;
  std::uint64_t last_clocks_ = 0;
  std::uint32_t root_ = 0;  ///< address
};

}  // namespace csgsim::m68000
