#include "sim/studies/mesh/price.h"

#include <initializer_list>

namespace csgsim::studies {

namespace {

using software::Operation;
using software::Operations;

struct Part {
  Operation kind;
  std::uint64_t times;
};

void add(Operations& sum, std::uint64_t count, std::initializer_list<Part> parts) {
  for (const auto& [kind, times] : parts) sum.counts[static_cast<std::size_t>(kind)] += count * times;
}

/// Adds the price of additions and halvings of longs in place.
void price_adds(Operations& sum, std::uint64_t count) {
  add(sum, count, {{Operation::load_long, 1}, {Operation::add_long, 1}});
}

/// Adds the price of a subroutine with four word multiplications, additions of the partial products, and sign handling.
void price_products(Operations& sum, std::uint64_t count) {
  add(sum, count,
      {{Operation::load_long, 2},
       {Operation::call, 1},
       {Operation::come_back, 1},
       {Operation::multiply, 4},
       {Operation::move, 6},
       {Operation::add_long, 4},
       {Operation::compare_long, 2},
       {Operation::branch, 2}});
}

/// Adds the price of long divisions, one quotient bit at a time.
void price_quotients(Operations& sum, std::uint64_t count, std::uint64_t bits) {
  add(sum, count,
      {{Operation::load_long, 2},
       {Operation::call, 1},
       {Operation::come_back, 1},
       {Operation::shift_long, bits},
       {Operation::shifted_bit, bits},
       {Operation::compare_long, bits},
       {Operation::add_long, bits},
       {Operation::branch_taken, bits}});
}

constexpr std::uint64_t quotient_bits = 32;
constexpr std::uint64_t root_bits = 16;

}  // namespace

Operations subdivision_operations(const MeshRow& row) {
  Operations sum;
  price_adds(sum, row.adds);
  price_products(sum, row.products);
  price_quotients(sum, row.quotients, quotient_bits);
  price_quotients(sum, row.roots, root_bits);
  // A node: calls of Subdivide with two pointers, and the corners stored into a record.
  add(sum, row.tree_nodes,
      {{Operation::call, 4}, {Operation::come_back, 4}, {Operation::store_long, 14}, {Operation::load_long, 4}});
  add(sum, row.halvings, {{Operation::store_long, 16}, {Operation::call, 1}, {Operation::come_back, 1}});
  add(sum, row.flat_tests, {{Operation::compare_long, 1}, {Operation::branch, 1}});
  return sum;
}

Operations repair_operations(const MeshRow& row) {
  Operations sum;
  // An element: a record of its square, corners and sides is written and read; Traverse and two calls of Increment.
  add(sum, row.elements,
      {{Operation::call, 5},
       {Operation::come_back, 5},
       {Operation::store_long, 20},
       {Operation::load_long, 20},
       {Operation::add, 8},
       {Operation::branch, 8}});
  // A vertex: its coordinates and its reference count.
  add(sum, row.vertices,
      {{Operation::store_long, 5}, {Operation::load_long, 4}, {Operation::add, 8}, {Operation::branch, 4}});
  // A visited edge of a list, or node of a tree.
  add(sum, row.edge_visits, {{Operation::load_long, 3}, {Operation::compare, 2}, {Operation::branch_taken, 2}});
  // A record of an edge is allocated and filled, or cleared and freed.
  add(sum, row.splits, {{Operation::load_long, 7}, {Operation::store_long, 9}, {Operation::add, 3}});
  add(sum, row.merges, {{Operation::load_long, 5}, {Operation::store_long, 5}, {Operation::add, 3}});
  // Interpolation of three coordinates; the parameter is a number of halves.
  add(sum, row.snaps, {{Operation::call, 1}, {Operation::come_back, 1}, {Operation::store_long, 6}});
  price_adds(sum, 6 * row.snaps);
  price_products(sum, 3 * row.snaps);
  return sum;
}

MeshSeconds seconds_of(const MeshRow& row, const processors::Processor& processor) {
  return {processors::seconds(subdivision_operations(row), processor),
          processors::seconds(repair_operations(row), processor)};
}

}  // namespace csgsim::studies
