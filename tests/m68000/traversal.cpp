#include "tests/m68000/traversal.h"

#include <array>
#include <span>
#include <stdexcept>

#include "tests/m68000/developed_tree.h"

namespace csgsim::m68000 {

namespace by_hand {
#include "tests/m68000/programs.inc"
inline constexpr std::uint32_t statuses_at = 0x4000;
inline constexpr std::uint32_t leaves_at = 0x4800;
inline constexpr std::uint32_t status_bits_at = 0x5800;
inline constexpr std::uint32_t bits_at = 0x5804;
inline constexpr std::uint32_t codes_at = 0x6000;
inline constexpr std::uint32_t list_at = 0x7000;
}  // namespace by_hand

namespace compiled_plainly {
#include "tests/m68000/compiled/plain.inc"
}

namespace compiled_optimised {
#include "tests/m68000/compiled/optimised.inc"
}

struct Program {
  std::span<const std::uint16_t> words;
  std::array<std::uint32_t, 5> evaluate;  ///< addresses of subroutines, by method
  std::array<std::uint32_t, 5> flip;
  std::uint32_t statuses;  ///< addresses of tables
  std::uint32_t leaves;
  std::uint32_t status_bits;  ///< address of a long
  std::uint32_t bits;         ///< address of a table
  std::uint32_t codes;        ///< address of a table
  std::uint32_t list;
};

namespace {

constexpr std::uint32_t program_at = 0x1000;
constexpr std::uint32_t levels_at = 0x8000;
constexpr std::uint32_t nodes_at = 0x10000;
constexpr std::uint32_t memory_bytes = 0x80000;
constexpr std::uint64_t most_instructions = 1'000'000;
constexpr std::size_t most_primitives = 1024;

/// Size of a node and offsets of its members, in bytes.
constexpr std::uint32_t node_bytes = 22;
constexpr std::uint32_t number_offset = 2;
constexpr std::uint32_t status_offset = 4;
constexpr std::uint32_t left_offset = 6;
constexpr std::uint32_t right_offset = 10;
constexpr std::uint32_t father_offset = 14;
constexpr std::uint32_t middle_offset = 18;
constexpr std::uint32_t last_offset = 20;

/// Ends a list of codes.
constexpr std::uint32_t no_code = 0x7fff;

/// Indexed by Written.
const std::array programs{
    Program{by_hand::words,
            {by_hand::standard_at, by_hand::early_out_at, by_hand::look_at, by_hand::bit_parallel_at,
             by_hand::positional_at},
            {by_hand::invert_at, by_hand::invert_at, by_hand::flip_status_at, by_hand::invert_bit_at,
             by_hand::change_list_at},
            by_hand::statuses_at,
            by_hand::leaves_at,
            by_hand::status_bits_at,
            by_hand::bits_at,
            by_hand::codes_at,
            by_hand::list_at},
    Program{compiled_plainly::words,
            {compiled_plainly::standard_at, compiled_plainly::early_out_at, compiled_plainly::look_at,
             compiled_plainly::bit_parallel_at, compiled_plainly::positional_at},
            {compiled_plainly::invert_at, compiled_plainly::invert_at, compiled_plainly::flip_status_at,
             compiled_plainly::invert_bit_at, compiled_plainly::change_list_at},
            compiled_plainly::statuses_at,
            compiled_plainly::leaves_at,
            compiled_plainly::status_bits_at,
            compiled_plainly::bits_at,
            compiled_plainly::codes_at,
            compiled_plainly::list_at},
    Program{compiled_optimised::words,
            {compiled_optimised::standard_at, compiled_optimised::early_out_at, compiled_optimised::look_at,
             compiled_optimised::bit_parallel_at, compiled_optimised::positional_at},
            {compiled_optimised::invert_at, compiled_optimised::invert_at, compiled_optimised::flip_status_at,
             compiled_optimised::invert_bit_at, compiled_optimised::change_list_at},
            compiled_optimised::statuses_at,
            compiled_optimised::leaves_at,
            compiled_optimised::status_bits_at,
            compiled_optimised::bits_at,
            compiled_optimised::codes_at,
            compiled_optimised::list_at}};

std::uint32_t address_of(std::size_t node) { return nodes_at + node_bytes * static_cast<std::uint32_t>(node); }

}  // namespace

M68000Traversal::M68000Traversal(Method method, Written written)
    : method_(method),
      written_(written),
      program_(programs[static_cast<std::size_t>(written)]),
      processor_(memory_bytes) {
  std::uint32_t at = program_at;
  for (const std::uint16_t word : program_.words) {
    processor_.write(at, Size::word, word);
    at += 2;
  }
}

void M68000Traversal::load(const Tree& tree) {
  if (method_ == Method::bit_parallel) {
    put_levels(tree);
  } else {
    put_nodes(tree);
    put_codes(tree, tree.root, 0);
    processor_.write(program_.list, Size::word, no_code);
  }
  clocks_ = 0;
  last_clocks_ = 0;
}

void M68000Traversal::put_nodes(const Tree& tree) {
  if (tree.nodes.size() >= 2 * most_primitives) throw std::out_of_range("the tree has too many nodes");
  // Assembly programs expect numbers as offsets of words.
  const std::uint32_t number_scale = written_ == Written::by_hand ? 2 : 1;
  const auto put_long = [&](std::uint32_t address, std::uint32_t value) {
    processor_.write(address, Size::longword, value);
  };
  object_ = address_of(tree.root);
  put_long(object_ + father_offset, 0);
  for (std::size_t index = 0; index < tree.nodes.size(); ++index) {
    const TreeNode& node = tree.nodes[index];
    const std::uint32_t at = address_of(index);
    processor_.write(at, Size::word, static_cast<std::uint32_t>(node.kind));
    processor_.write(at + status_offset, Size::word, 0);
    if (node.kind == NodeKind::primitive) {
      processor_.write(at + number_offset, Size::word, number_scale * node.primitive);
      processor_.write(program_.statuses + std::uint32_t{2} * node.primitive, Size::word, 0);
      put_long(program_.leaves + std::uint32_t{4} * node.primitive, at);
      continue;
    }
    put_long(at + left_offset, address_of(node.left));
    put_long(at + right_offset, address_of(node.right));
    put_long(address_of(node.left) + father_offset, at);
    put_long(address_of(node.right) + father_offset, at);
  }
}

std::uint32_t M68000Traversal::put_codes(const Tree& tree, std::size_t index, std::uint32_t first) {
  const TreeNode& node = tree.nodes[index];
  std::uint32_t behind = first + 1;
  if (node.kind == NodeKind::primitive) {
    processor_.write(program_.codes + std::uint32_t{2} * node.primitive, Size::word, first);
  } else {
    const std::uint32_t middle = put_codes(tree, node.left, first);
    processor_.write(address_of(index) + middle_offset, Size::word, middle);
    behind = put_codes(tree, node.right, middle);
  }
  processor_.write(address_of(index) + last_offset, Size::word, behind - 1);
  return behind;
}

void M68000Traversal::put_levels(const Tree& tree) {
  const DevelopedTree developed = develop(tree);
  object_ = levels_at;
  // Assembly counts down to -1.
  const std::size_t count = developed.inverted.size() - (written_ == Written::by_hand ? 1 : 0);
  processor_.write(levels_at, Size::word, static_cast<std::uint32_t>(count));
  std::uint32_t at = levels_at + 2;
  for (const std::uint32_t inverted : developed.inverted) {
    processor_.write(at, Size::longword, inverted);
    at += 4;
  }
  processor_.write(program_.status_bits, Size::longword, 0);
  for (const auto& [primitive, bit] : developed.bits)
    processor_.write(program_.bits + std::uint32_t{4} * primitive, Size::longword, bit);
}

void M68000Traversal::flip(std::uint16_t primitive) {
  processor_.d[0] = primitive;
  call(program_.flip[static_cast<std::size_t>(method_)], primitive);
}

bool M68000Traversal::evaluate() {
  processor_.a[0] = object_;
  call(program_.evaluate[static_cast<std::size_t>(method_)], object_);
  const std::uint32_t result = processor_.d[0];
  return method_ == Method::bit_parallel ? result >> 31U != 0 : (result & 0xffffU) != 0;
}

/// Assembly expects its argument in a register, C on the stack.
void M68000Traversal::call(std::uint32_t address, std::uint32_t argument) {
  const std::uint32_t tables[] = {program_.statuses, program_.statuses, program_.leaves, program_.status_bits,
                                  program_.list};
  processor_.a[1] = tables[static_cast<std::size_t>(method_)];
  processor_.a[2] = method_ == Method::positional ? program_.codes : program_.bits;
  processor_.a[7] = memory_bytes - 4;
  processor_.write(processor_.a[7], Size::longword, argument);
  const std::uint64_t before = processor_.clocks();
  processor_.call(address, most_instructions);
  last_clocks_ = processor_.clocks() - before;
  clocks_ += last_clocks_;
}

}  // namespace csgsim::m68000
