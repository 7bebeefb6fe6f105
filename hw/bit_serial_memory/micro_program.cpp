#include "hw/bit_serial_memory/micro_program.h"

#include <memory>
#include <vector>

#include "hw/bit_serial_memory/column_logic.h"
#include "hw/bit_serial_memory/expression_sum.h"
#include "hw/bit_serial_memory/root_program.h"
#include "hw/isa/opcodes.h"

namespace csgsim::bit_serial_memory {

namespace {

/// Compiles one instruction.
class Compiler {
 public:
  Compiler(const isa::Instruction& instruction, const MicroDesign& design, ColumnLogic& logic)
      : instruction_(instruction), design_(design), logic_(logic) {}

  void compile();

 private:
  [[nodiscard]] const isa::Linear& linear() const { return instruction_.linear; }
  [[nodiscard]] unsigned width(unsigned operand) const { return instruction_.fields.at(operand).width; }
  [[nodiscard]] Row row(unsigned operand, unsigned bit) const {
    return static_cast<Row>(instruction_.fields.at(operand).base + bit);
  }
  [[nodiscard]] Bit field_bit(unsigned operand, unsigned bit) const { return Bit::of_row(row(operand, bit)); }
  [[nodiscard]] std::vector<Bit> field_bits(unsigned operand) const {
    std::vector<Bit> bits;
    for (unsigned bit = 0; bit < width(operand); ++bit) bits.push_back(field_bit(operand, bit));
    return bits;
  }
  [[nodiscard]] bool constant_bit(unsigned bit) const { return (instruction_.constant >> bit & 1U) != 0; }

  std::vector<Bit> value(bool sign_alone = false);
  [[nodiscard]] std::vector<Bit> repeat(std::vector<Bit> f);
  void skip_fraction(unsigned bits);
  void narrow_by_sign(bool negative);
  void compare_value(const std::vector<Bit>& f, bool from_one);
  void equal_value();
  void load();
  void keep(bool greatest);
  void put(std::span<const Bit> f, Mask mask);
  void compare_fields(bool from_one);
  void equal_fields();
  void combine_fields(BinaryOp op);
  void add_field();
  void add_value(Chain chain);
  void query_enable();

  const isa::Instruction& instruction_;
  const MicroDesign& design_;
  ColumnLogic& logic_;
};

/// Discards bits that the trees deliver before the required ones.
void Compiler::skip_fraction(unsigned bits) {
  for (unsigned bit = 0; bit < bits; ++bit) logic_.emit({.op = RowOp::leaf, .bit = static_cast<std::uint8_t>(bit)});
}

/// Bits of F above its fraction, or only its sign.
std::vector<Bit> Compiler::value(bool sign_alone) {
  const unsigned first = sign_alone ? linear().width - 1U : linear().shift;
  std::vector<Bit> f;
  switch (design_.expressions) {
    case Expressions::rows: {
      const std::vector<Bit> sum = sum_expression(linear(), {linear().shift, sign_alone}, logic_);
      return {sum.begin() + first, sum.end()};
    }
    case Expressions::planes:
      for (unsigned bit = first; bit < linear().width; ++bit) {
        logic_.emit({.op = RowOp::receive, .bit = static_cast<std::uint8_t>(bit), .to = logic_.map().sum(bit)});
        f.push_back(Bit::of_row(logic_.map().sum(bit)));
      }
      return f;
    case Expressions::trees:
      skip_fraction(first);
      for (unsigned bit = first; bit < linear().width; ++bit) f.push_back(Bit::of_leaf(bit));
      return f;
  }
  return f;
}

/// Returns the bits for a second use. Trees must deliver them again.
std::vector<Bit> Compiler::repeat(std::vector<Bit> f) {
  if (design_.expressions == Expressions::trees) skip_fraction(linear().shift);
  return f;
}

void Compiler::narrow_by_sign(bool negative) {
  logic_.change_enable(negative ? BinaryOp::conjunction : BinaryOp::and_not, value(true).back());
}

/// Leaves F < s in the borrow, or F <= s if `from_one`. A negative F yields 1.
void Compiler::compare_value(const std::vector<Bit>& f, bool from_one) {
  logic_.begin_chain(Chain::difference, from_one);
  for (unsigned bit = 0; bit + 1 < f.size(); ++bit)
    logic_.carry(f[bit], bit < width(0) ? field_bit(0, bit) : Bit::constant(false));
  logic_.carry(Bit::constant(false), f.back());
}

void Compiler::equal_value() {
  const std::vector<Bit> f = value();
  logic_.narrow_equal(std::span(f).first(width(0)), field_bits(0));
  logic_.drop_where_any(std::span(f).subspan(width(0)), Mask::enable);
}

void Compiler::put(std::span<const Bit> f, Mask mask) {
  for (unsigned bit = 0; bit < width(0); ++bit) logic_.store(row(0, bit), f[bit], mask);
  logic_.drop_where_any(f.subspan(width(0)), mask);
}

void Compiler::load() { put(value(), Mask::enable); }

void Compiler::keep(bool greatest) {
  const std::vector<Bit> f = value();
  compare_value(f, greatest);
  logic_.select_by_chain(greatest);
  put(repeat(f), Mask::select);
}

void Compiler::compare_fields(bool from_one) {
  logic_.begin_chain(Chain::difference, from_one);
  for (unsigned bit = 0; bit < width(0); ++bit) logic_.carry(field_bit(0, bit), field_bit(1, bit));
  logic_.narrow_by_chain(false);
}

void Compiler::equal_fields() { logic_.narrow_equal(field_bits(0), field_bits(1)); }

void Compiler::combine_fields(BinaryOp op) {
  for (unsigned bit = 0; bit < width(0); ++bit)
    logic_.store_combined(op, row(0, bit), field_bit(1, bit), field_bit(2, bit), Mask::enable);
}

void Compiler::add_field() {
  logic_.begin_chain(Chain::sum, false);
  for (unsigned bit = 0; bit < width(0); ++bit)
    logic_.store_sum(row(0, bit), bit < width(1) ? field_bit(1, bit) : Bit::constant(false), field_bit(0, bit),
                     Mask::enable);
}

void Compiler::add_value(Chain chain) {
  const std::vector<Bit> f = value();
  logic_.begin_chain(chain, false);
  for (unsigned bit = 0; bit < width(0); ++bit) logic_.store_sum(row(0, bit), f[bit], field_bit(0, bit), Mask::enable);
}

/// Queries the global OR: through the wired OR, or through the host, which reads the row.
void Compiler::query_enable() {
  if (design_.has_wired_or) {
    logic_.sense_enable();
    return logic_.emit({.op = RowOp::wired_or});
  }
  logic_.emit({.op = RowOp::send, .from = WordLines(logic_.enable_row())});
}

void Compiler::compile() {
  using isa::Opcode;
  switch (instruction_.opcode) {
    case Opcode::enable_all: return logic_.set_enable(Bit::constant(true));
    case Opcode::enable_invert: return logic_.invert_enable();
    case Opcode::enable_load: return logic_.set_enable(field_bit(0, 0));
    case Opcode::enable_and: return logic_.change_enable(BinaryOp::conjunction, field_bit(0, 0));
    case Opcode::enable_and_not: return logic_.change_enable(BinaryOp::and_not, field_bit(0, 0));
    case Opcode::enable_or: return logic_.change_enable(BinaryOp::disjunction, field_bit(0, 0));
    case Opcode::enable_xor: return logic_.change_enable(BinaryOp::unequal, field_bit(0, 0));
    case Opcode::enable_store: return logic_.store_enable(row(0, 0));
    case Opcode::edge_not_negative: return narrow_by_sign(false);
    case Opcode::edge_negative:
    case Opcode::stripe: return narrow_by_sign(true);
    case Opcode::linear_ge: compare_value(value(), false); return logic_.narrow_by_chain(true);
    case Opcode::linear_gt: compare_value(value(), true); return logic_.narrow_by_chain(true);
    case Opcode::linear_le: compare_value(value(), true); return logic_.narrow_by_chain(false);
    case Opcode::linear_lt: compare_value(value(), false); return logic_.narrow_by_chain(false);
    case Opcode::linear_eq: return equal_value();
    case Opcode::load_linear: return load();
    case Opcode::keep_max: return keep(true);
    case Opcode::keep_min: return keep(false);
    case Opcode::set_constant:
      for (unsigned bit = 0; bit < width(0); ++bit)
        logic_.store(row(0, bit), Bit::constant(constant_bit(bit)), Mask::enable);
      return;
    case Opcode::copy:
      for (unsigned bit = 0; bit < width(0); ++bit) logic_.store(row(0, bit), field_bit(1, bit), Mask::enable);
      return;
    case Opcode::field_lt: return compare_fields(false);
    case Opcode::field_le: return compare_fields(true);
    case Opcode::field_eq: return equal_fields();
    case Opcode::bit_and: return combine_fields(BinaryOp::conjunction);
    case Opcode::bit_or: return combine_fields(BinaryOp::disjunction);
    case Opcode::bit_xor: return combine_fields(BinaryOp::unequal);
    case Opcode::bit_and_not: return combine_fields(BinaryOp::and_not);
    case Opcode::bit_not:
      for (unsigned bit = 0; bit < width(0); ++bit) logic_.store(row(0, bit), field_bit(1, bit), Mask::enable, true);
      return;
    case Opcode::global_or:
    case Opcode::skip_if_none: return query_enable();
    case Opcode::xor_constant:
      for (unsigned bit = 0; bit < width(0); ++bit) {
        if (constant_bit(bit)) logic_.toggle(row(0, bit));
      }
      return;
    case Opcode::add: return add_field();
    case Opcode::squares: return;
    case Opcode::linear_plus: return add_value(Chain::sum);
    case Opcode::linear_minus: return add_value(Chain::difference);
    case Opcode::root: return write_root(instruction_.fields[0], logic_);
  }
}

}  // namespace

RowCommands micro_program(const isa::Instruction& instruction, const RowMap& map, const MicroDesign& design) {
  RowCommands commands;
  const std::unique_ptr<ColumnLogic> logic = make_column_logic(design.design, map, design.enable_latch, commands);
  Compiler(instruction, design, *logic).compile();
  logic->end();
  return commands;
}

RowCommands clear_program(const RowMap& map, const MicroDesign& design) {
  RowCommands commands;
  const std::unique_ptr<ColumnLogic> logic = make_column_logic(design.design, map, design.enable_latch, commands);
  for (unsigned bit = 0; bit < map.memory_bits; ++bit) logic->assign(static_cast<Row>(bit), Bit::constant(false));
  logic->set_enable(Bit::constant(false));
  logic->end();
  return commands;
}

RowCommands send_program(isa::Field field) {
  RowCommands commands;
  for (unsigned bit = 0; bit < field.width; ++bit)
    commands.push_back({.op = RowOp::send, .from = WordLines(static_cast<Row>(field.base + bit))});
  return commands;
}

}  // namespace csgsim::bit_serial_memory
