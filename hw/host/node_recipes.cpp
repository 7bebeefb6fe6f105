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
Operations plane_transform_operations() {
  Operations all = 12 * number_multiplied;
  all += recipe("quotients");
  all += recipe("planes");
  return all;
}

Operations box_test_operations() { return recipe("boxes"); }
Operations halfspace_test_operations() { return recipe("tests"); }

/// Values at four corners, each compared with its corner's leader; one test in four compares the other twelve leaders.
Operations cell_test_operations() {
  Operations all = 4 * recipe("values");
  all += 3 * leader_compared;
  return all;
}

Operations node_visit_operations() {
  Operations all = recipe("nodes");
  all += recipe("boxes");
  return all;
}

/// Stores the words of an instruction as three longs.
Operations instruction_listing_operations() {
  Operations all = expression_fitting_operations();
  all += 3 * long_store_operations();
  return all;
}

/// The width is that of the four values at the corners, which are known; three words are stored.
Operations number_listing_operations() { return number_listed; }

Operations field_search_operations() { return field_found; }
Operations call_linking_operations() { return call_linked; }
Operations call_operations() { return call_made; }
Operations pixel_loop_operations() { return pixel_repeated; }
Operations row_loop_operations() { return row_repeated; }
Operations instruction_loop_operations() { return instruction_repeated; }

}  // namespace csgsim::host
