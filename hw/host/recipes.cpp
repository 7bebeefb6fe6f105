#include "hw/host/recipes.h"

#include <algorithm>
#include <array>

#include "hw/base/quotient.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/operands.h"
#include "hw/isa/wire.h"

namespace csgsim::host {

namespace {

using processors::made;
using processors::Operation;
using processors::Operations;

// Recipes. Numbers of the model and of matrices are longs.
constexpr Operations plane = made({{Operation::load_long, 20},
                                   {Operation::multiply_long, 16},
                                   {Operation::add_long, 12},
                                   {Operation::divide_long, 3},
                                   {Operation::shift_long, 3},
                                   {Operation::shifted_bit, 36},
                                   {Operation::compare_long, 2},
                                   {Operation::branch, 2},
                                   {Operation::store_long, 3}});
constexpr Operations point = made({{Operation::load_long, 15},
                                   {Operation::multiply_long, 9},
                                   {Operation::add_long, 9},
                                   {Operation::divide_long, 2},
                                   {Operation::compare_long, 6},
                                   {Operation::branch, 6},
                                   {Operation::store_long, 2}});
constexpr Operations colour = made({{Operation::load_long, 6},
                                    {Operation::multiply_long, 6},
                                    {Operation::add_long, 5},
                                    {Operation::compare_long, 3},
                                    {Operation::branch, 3},
                                    {Operation::shift_long, 2},
                                    {Operation::shifted_bit, 24},
                                    {Operation::logic_long, 2},
                                    {Operation::store_long, 1}});
constexpr Operations box = made({{Operation::load, 4},
                                 {Operation::load_long, 2},
                                 {Operation::compare, 4},
                                 {Operation::compare_long, 2},
                                 {Operation::branch, 6},
                                 {Operation::add_long, 1},
                                 {Operation::branch_taken, 1}});
constexpr Operations halfspace = made({{Operation::load_long, 3},
                                       {Operation::load, 4},
                                       {Operation::multiply, 8},
                                       {Operation::add_long, 10},
                                       {Operation::compare_long, 6},
                                       {Operation::branch, 6},
                                       {Operation::branch_taken, 1}});
constexpr Operations value = made({{Operation::load_long, 1},
                                   {Operation::add_long, 2},
                                   {Operation::compare_long, 1},
                                   {Operation::branch, 1},
                                   {Operation::branch_taken, 1}});
constexpr Operations support = made({{Operation::load_long, 3},
                                     {Operation::multiply_long, 3},
                                     {Operation::add_long, 3},
                                     {Operation::compare_long, 1},
                                     {Operation::branch, 1},
                                     {Operation::branch_taken, 1}});
constexpr Operations node = made({{Operation::load, 2},
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
});

/// Selection of the next instruction and the call of the procedure that assembles it.
constexpr Operations any_instruction = made({{Operation::load, 2},
                                             {Operation::move, 2},
                                             {Operation::compare, 2},
                                             {Operation::branch, 2},
                                             {Operation::call, 1},
                                             {Operation::come_back, 1}});

/// Another number shifted to its place behind the previous numbers.
constexpr Operations packed = made({{Operation::load_long, 1},
                                    {Operation::shift_long, 1},
                                    {Operation::shifted_bit, 16},
                                    {Operation::logic_long, 2},
                                    {Operation::add, 1}});

/// The constant moved to the segment's corner, by two products of a long and a word.
constexpr Operations moved =
    made({{Operation::load_long, 3}, {Operation::load, 2}, {Operation::multiply, 4}, {Operation::add_long, 4}});

/// Common trailing zeros of the coefficients, and a width, each found by five halvings of a long.
constexpr Operations fitted = made({{Operation::logic_long, 6},
                                    {Operation::compare_long, 5},
                                    {Operation::branch, 10},
                                    {Operation::shift_long, 3},
                                    {Operation::shifted_bit, 24}});

/// A quadratic expression moved to the corner, which also changes its linear part.
constexpr Operations squares_moved =
    made({{Operation::load_long, 6}, {Operation::load, 2}, {Operation::multiply, 16}, {Operation::add_long, 16}});

constexpr Operations long_stored = made(
    {{Operation::store_long, 1}, {Operation::add_long, 1}, {Operation::compare_long, 1}, {Operation::branch_taken, 1}});

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

}  // namespace

std::span<const Recipe> recipes() { return rows; }

Operations recipe(std::string_view name) { return std::ranges::find(rows, name, &Recipe::name)->each; }

Operations count_operations(const isa::Preparation& preparation) {
  Operations all;
  for (const Recipe& one : rows) all += preparation.*one.count * one.each;
  return all;
}

void Written::add(const isa::Instruction& instruction, unsigned link_width) {
  const isa::Operands& operands = isa::operands_of(instruction.opcode);
  ++instructions;
  numbers += numbers_in(instruction);
  if (isa::has_operand(operands, isa::OperandKind::linear)) ++linear;
  if (isa::has_operand(operands, isa::OperandKind::squares)) ++squares;
  longs += std::uint64_t{isa::wire_words(instruction, link_width)} * quotient_up(link_width, long_bits);
}

Operations count_operations(const Written& written) {
  Operations all = written.instructions * any_instruction;
  all += (written.instructions + written.numbers) * packed;
  for (const Operations& each : {moved, halfspace, fitted}) all += written.linear * each;
  all += written.squares * squares_moved;
  all += written.longs * long_stored;
  return all;
}

Operations count_operations(const isa::Instruction& instruction, unsigned link_width) {
  Written written;
  written.add(instruction, link_width);
  return count_operations(written);
}

Operations fitted_expression() {
  Operations all = moved;
  all += fitted;
  return all;
}

Operations stored_long() { return long_stored; }

std::uint64_t model_longs(const isa::Program& program) {
  constexpr std::uint64_t bytes_of_long = 4;
  return quotient_up(std::uint64_t{program.display_model.size()}, bytes_of_long);
}

Operations model_long_operations() {
  Operations all = 2 * packed;
  all += long_stored;
  return all;
}

}  // namespace csgsim::host
