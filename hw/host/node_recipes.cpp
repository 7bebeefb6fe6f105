#include "hw/host/node_recipes.h"

#include "hw/host/recipes.h"

namespace csgsim::host {

namespace {

using processors::Operation;
using processors::operation_counts;
using processors::Operations;

/// A number read and multiplied by one that the host's recipes read, from a table of products.
constexpr Operations number_multiplied = operation_counts({{Operation::load_long, 1}, {Operation::multiply_long, 1}});

/// Another leader of a cell read, compared and branched on.
constexpr Operations leader_compared =
    operation_counts({{Operation::load_long, 1}, {Operation::compare_long, 1}, {Operation::branch, 1}});

constexpr Operations number_listed =
    operation_counts({{Operation::compare_long, 4}, {Operation::branch, 4}, {Operation::store, 3}});
constexpr Operations field_found =
    operation_counts({{Operation::add, 1}, {Operation::compare, 1}, {Operation::branch_taken, 1}});
constexpr Operations call_linked = operation_counts({{Operation::store, 3}, {Operation::add_long, 1}});
constexpr Operations call_made = operation_counts({{Operation::call, 1}, {Operation::come_back, 1}});
constexpr Operations pixel_repeated = operation_counts({{Operation::branch_taken, 1}});
constexpr Operations row_repeated =
    operation_counts({{Operation::branch_taken, 1}, {Operation::add_long, 2}, {Operation::move, 1}});
constexpr Operations instruction_repeated = operation_counts(
    {{Operation::load, 1}, {Operation::load_long, 1}, {Operation::branch_taken, 1}, {Operation::come_back, 1}});

}  // namespace

/// Without tables each component of the normal is multiplied by four numbers of the matrix, one of them for the offset.
Operations transformed_plane() {
  Operations all = 12 * number_multiplied;
  all += recipe("quotients");
  all += recipe("planes");
  return all;
}

Operations tested_box() { return recipe("boxes"); }
Operations tested_halfspace() { return recipe("tests"); }

/// Values at four corners, each compared with its corner's leader; one test in four compares the other twelve leaders.
Operations tested_cell() {
  Operations all = 4 * recipe("values");
  all += 3 * leader_compared;
  return all;
}

Operations visited_node() {
  Operations all = recipe("nodes");
  all += recipe("boxes");
  return all;
}

/// Stores the words of an instruction as three longs.
Operations listed_instruction() {
  Operations all = fitted_expression();
  all += 3 * stored_long();
  return all;
}

/// The width is that of the four values at the corners, which are known; three words are stored.
Operations listed_number() { return number_listed; }

Operations found_field() { return field_found; }
Operations linked_call() { return call_linked; }
Operations called() { return call_made; }
Operations repeated_pixel() { return pixel_repeated; }
Operations repeated_row() { return row_repeated; }
Operations repeated_instruction() { return instruction_repeated; }

}  // namespace csgsim::host
