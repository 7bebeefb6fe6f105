#include "hw/host/recipes.h"

#include <algorithm>
#include <array>

#include "hw/base/quotient.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/operands.h"
#include "hw/isa/wire.h"

namespace csgsim::host {

namespace {

using processors::Operation;
using processors::operation_counts;
using processors::Operations;

// Recipes. Numbers of the model and of matrices are longs.

/// A distinct coordinate times a number of the matrix, stored in a table.
constexpr Operations product = operation_counts({{Operation::load_long, 2},
                                                 {Operation::multiply_long, 1},
                                                 {Operation::add_long, 1},
                                                 {Operation::compare_long, 1},
                                                 {Operation::branch_taken, 1},
                                                 {Operation::store_long, 1}});

/// Three sums of three products; the reciprocal of one sum, times the others; stored. The divisor is aligned first, and
/// both products by its places.
constexpr Operations quotient = operation_counts({{Operation::load_long, 9},
                                                  {Operation::add_long, 6},
                                                  {Operation::divide_long, 1},
                                                  {Operation::multiply_long, 2},
                                                  {Operation::shift_long, 3},
                                                  {Operation::shifted_bit, 36},
                                                  {Operation::compare_long, 2},
                                                  {Operation::branch, 2},
                                                  {Operation::store_long, 3}});

/// The sum of a plane's offset and three products, times the reciprocal of its direction; aligned by the places stored
/// with the reciprocal, and stored.
constexpr Operations plane = operation_counts({{Operation::load_long, 6},
                                               {Operation::add_long, 3},
                                               {Operation::multiply_long, 1},
                                               {Operation::shift_long, 1},
                                               {Operation::shifted_bit, 12},
                                               {Operation::compare_long, 2},
                                               {Operation::branch, 2},
                                               {Operation::store_long, 1}});

/// Three sums of three products, and the update of a box.
constexpr Operations point = operation_counts({{Operation::load_long, 9},
                                               {Operation::add_long, 6},
                                               {Operation::compare_long, 6},
                                               {Operation::branch, 6},
                                               {Operation::store_long, 3}});
constexpr Operations colour = operation_counts({{Operation::load_long, 6},
                                                {Operation::multiply_long, 6},
                                                {Operation::add_long, 5},
                                                {Operation::compare_long, 3},
                                                {Operation::branch, 3},
                                                {Operation::shift_long, 2},
                                                {Operation::shifted_bit, 24},
                                                {Operation::logic_long, 2},
                                                {Operation::store_long, 1}});
constexpr Operations box = operation_counts({{Operation::load, 4},
                                             {Operation::load_long, 2},
                                             {Operation::compare, 4},
                                             {Operation::compare_long, 2},
                                             {Operation::branch, 6},
                                             {Operation::add_long, 1},
                                             {Operation::branch_taken, 1}});
constexpr Operations halfspace = operation_counts({{Operation::load_long, 3},
                                                   {Operation::load, 4},
                                                   {Operation::multiply, 8},
                                                   {Operation::add_long, 10},
                                                   {Operation::compare_long, 6},
                                                   {Operation::branch, 6},
                                                   {Operation::branch_taken, 1}});
constexpr Operations value = operation_counts({{Operation::load_long, 1},
                                               {Operation::add_long, 2},
                                               {Operation::compare_long, 1},
                                               {Operation::branch, 1},
                                               {Operation::branch_taken, 1}});
constexpr Operations support = operation_counts({{Operation::load_long, 3},
                                                 {Operation::multiply_long, 3},
                                                 {Operation::add_long, 3},
                                                 {Operation::compare_long, 1},
                                                 {Operation::branch, 1},
                                                 {Operation::branch_taken, 1}});
constexpr Operations node = operation_counts({{Operation::load, 2},
                                              {Operation::load_long, 1},
                                              {Operation::add_long, 2},
                                              {Operation::compare, 2},
                                              {Operation::branch, 2},
                                              {Operation::store_long, 1},
                                              {Operation::call, 1},
                                              {Operation::come_back, 1}});

constexpr auto rows = std::to_array<Recipe>({
    {"planes", &isa::Preparation::planes, plane},
    {"points", &isa::Preparation::points, point},
    {"colours", &isa::Preparation::colours, colour},
    {"boxes", &isa::Preparation::boxes, box},
    {"tests", &isa::Preparation::halfspaces, halfspace},
    {"values", &isa::Preparation::values, value},
    {"supports", &isa::Preparation::supports, support},
    {"nodes", &isa::Preparation::nodes, node},
    {"products", &isa::Preparation::products, product},
    {"quotients", &isa::Preparation::quotients, quotient},
});

/// Selection of the next instruction and the call of the procedure that assembles it.
constexpr Operations any_instruction = operation_counts({{Operation::load, 2},
                                                         {Operation::move, 2},
                                                         {Operation::compare, 2},
                                                         {Operation::branch, 2},
                                                         {Operation::call, 1},
                                                         {Operation::come_back, 1}});

/// Another number shifted to its place behind the previous numbers.
constexpr Operations packed = operation_counts({{Operation::load_long, 1},
                                                {Operation::shift_long, 1},
                                                {Operation::shifted_bit, 16},
                                                {Operation::logic_long, 2},
                                                {Operation::add, 1}});

/// The constant moved to the segment's corner, by two products of a long and a word.
constexpr Operations moved = operation_counts(
    {{Operation::load_long, 3}, {Operation::load, 2}, {Operation::multiply, 4}, {Operation::add_long, 4}});

/// Common trailing zeros of the coefficients, and a width, each found by five halvings of a long.
constexpr Operations fitted = operation_counts({{Operation::logic_long, 6},
                                                {Operation::compare_long, 5},
                                                {Operation::branch, 10},
                                                {Operation::shift_long, 3},
                                                {Operation::shifted_bit, 24}});

/// A quadratic expression moved to the corner, which also changes its linear part.
constexpr Operations squares_moved = operation_counts(
    {{Operation::load_long, 6}, {Operation::load, 2}, {Operation::multiply, 16}, {Operation::add_long, 16}});

/// The opcode put into words that are kept.
constexpr Operations renamed =
    operation_counts({{Operation::load_long, 1}, {Operation::logic_long, 2}, {Operation::move, 1}});

constexpr Operations long_stored = operation_counts(
    {{Operation::store_long, 1}, {Operation::add_long, 1}, {Operation::compare_long, 1}, {Operation::branch_taken, 1}});

/// A long of kept words, read to be stored.
constexpr Operations long_read = operation_counts({{Operation::load_long, 1}});

constexpr unsigned long_bits = 32;

/// The numbers of a command after its opcode: base and width of a field; width, shift and coefficients of an
/// expression, where each coefficient counts as the longs it needs.
std::uint64_t numbers_in(const isa::Instruction& instruction) {
  const std::uint64_t longs = quotient_up(unsigned{instruction.linear.width}, long_bits);
  std::uint64_t numbers = 0;
  for (const isa::OperandKind operand : isa::operands_of(instruction.opcode)) {
    switch (operand) {
      case isa::OperandKind::none: break;
      case isa::OperandKind::target:
      case isa::OperandKind::source: numbers += 2; break;
      case isa::OperandKind::linear: numbers += 2 + 3 * longs; break;
      case isa::OperandKind::squares: numbers += 1 + 3 * longs; break;
      case isa::OperandKind::constant:
      case isa::OperandKind::count: numbers += 1; break;
    }
  }
  return numbers;
}

/// A hash of numbers with 64 bits, so long that different ones are taken for equal less than once in 10^8 frames.
class Mixed {
 public:
  Mixed& add(std::uint64_t number) {
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15;
    hash_ = (hash_ ^ number) * odd;
    hash_ ^= hash_ >> 29U;
    return *this;
  }
  Mixed& add(const isa::Linear& linear) {
    for (const std::int64_t number : {linear.a, linear.b, linear.c}) add(static_cast<std::uint64_t>(number));
    return add(std::uint64_t{linear.width} << 16U | linear.shift);
  }
  [[nodiscard]] std::uint64_t hash() const { return hash_; }

 private:
  std::uint64_t hash_ = 0;
};

/// The hash of an expression in the row above, where its constant is smaller by B.
std::uint64_t in_row_above(isa::Linear linear) {
  linear.c -= linear.b;
  return Mixed().add(linear).hash();
}

/// The words of an instruction; with an expression, without the opcode, which is exchanged in kept words.
std::uint64_t words_of(const isa::Instruction& instruction, bool has_expression) {
  Mixed words;
  words.add(has_expression ? isa::opcode_numbers : static_cast<std::uint64_t>(instruction.opcode));
  for (const isa::Field& field : instruction.fields) words.add(std::uint64_t{field.base} << 16U | field.width);
  return words.add(instruction.linear).add(instruction.constant).hash();
}

}  // namespace

std::span<const Recipe> recipes() { return rows; }

Operations recipe(std::string_view task_name) { return std::ranges::find(rows, task_name, &Recipe::name)->each; }

Operations count_operations(const isa::Preparation& preparation) {
  Operations all;
  for (const Recipe& one : rows) all += preparation.*one.count * one.each;
  return all;
}

void Writer::begin(const isa::Region& region) {
  is_moved_ = region.x != 0 || region.y != 0;
  const bool follows = region.x == region_.x && region.y == region_.y + 1 && region_.height == 1;
  above_.clear();
  if (follows) above_.swap(expressions_);
  region_ = region;
  expressions_.clear();
  words_.clear();
}

void Writer::add(const isa::Instruction& instruction) {
  const isa::Operands& operands = isa::operands_of(instruction.opcode);
  const bool has_linear = isa::has_operand(operands, isa::OperandKind::linear);
  const bool has_squares = isa::has_operand(operands, isa::OperandKind::squares);
  const bool has_expression = has_linear || has_squares;
  const std::uint64_t longs =
      std::uint64_t{isa::wire_words(instruction, link_width_)} * quotient_up(link_width_, long_bits);
  ++written_.instructions;
  const bool is_new = (has_expression ? words_ : frame_words_).insert(words_of(instruction, has_expression)).second;
  if (!is_new) {
    ++written_.kept;
    written_.kept_longs += longs;
    return;
  }
  written_.numbers += numbers_in(instruction);
  written_.longs += longs;
  if (!has_expression || !expressions_.insert(Mixed().add(instruction.linear).hash()).second) return;
  if (has_squares) {
    ++written_.squares;
  } else {
    ++written_.linear;
    if (is_moved_ && !above_.contains(in_row_above(instruction.linear))) ++written_.moved;
  }
}

Operations count_operations(const Written& written) {
  Operations all = written.instructions * any_instruction;
  all += (written.instructions - written.kept + written.numbers) * packed;
  all += written.kept * renamed;
  all += written.kept_longs * long_read;
  all += (written.longs + written.kept_longs) * long_stored;
  all += written.linear * fitted;
  all += written.moved * moved;
  all += written.squares * squares_moved;
  return all;
}

Operations expression_fitting_operations() {
  Operations all = moved;
  all += fitted;
  return all;
}

Operations long_store_operations() { return long_stored; }

std::uint64_t model_long_count(const isa::Program& program) {
  constexpr std::uint64_t bytes_of_long = 4;
  return quotient_up(std::uint64_t{program.display_model.size()}, bytes_of_long);
}

Operations model_long_operations() {
  Operations all = 2 * packed;
  all += long_stored;
  return all;
}

}  // namespace csgsim::host
