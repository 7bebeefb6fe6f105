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

/// Sums and halves of longs, in place.
void price_adds(Operations& sum, std::uint64_t count) {
  add(sum, count, {{Operation::load_long, 1}, {Operation::add_long, 1}});
}

/// A subroutine: four products of words, put together, with the signs.
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

/// A bit of the quotient at a time.
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

Operations subdividing(const MeshRow& row) {
  Operations sum;
  price_adds(sum, row.adds);
  price_products(sum, row.products);
  price_quotients(sum, row.quotients, quotient_bits);
  price_quotients(sum, row.roots, root_bits);
  // A node: a call of Subdivide with two pointers, and the corners into a record.
  add(sum, row.tree_nodes,
      {{Operation::call, 4}, {Operation::come_back, 4}, {Operation::store_long, 14}, {Operation::load_long, 4}});
  add(sum, row.halvings, {{Operation::store_long, 16}, {Operation::call, 1}, {Operation::come_back, 1}});
  add(sum, row.flat_tests, {{Operation::compare_long, 1}, {Operation::branch, 1}});
  return sum;
}

Operations repairing(const MeshRow& row) {
  Operations sum;
  // An element: a record of its square, corners and sides, written and read; Traverse and two calls of Increment.
  add(sum, row.elements,
      {{Operation::call, 5},
       {Operation::come_back, 5},
       {Operation::store_long, 20},
       {Operation::load_long, 20},
       {Operation::add, 8},
       {Operation::branch, 8}});
  // A vertex: its coordinates and how often it is held.
  add(sum, row.vertices,
      {{Operation::store_long, 5}, {Operation::load_long, 4}, {Operation::add, 8}, {Operation::branch, 4}});
  // An edge of a list, or a node of a tree, that is looked at.
  add(sum, row.edge_visits, {{Operation::load_long, 3}, {Operation::compare, 2}, {Operation::branch_taken, 2}});
  // A record of an edge, taken and filled; or emptied and given back.
  add(sum, row.splits, {{Operation::load_long, 7}, {Operation::store_long, 9}, {Operation::add, 3}});
  add(sum, row.merges, {{Operation::load_long, 5}, {Operation::store_long, 5}, {Operation::add, 3}});
  // Three coordinates by a part of the way, which is a number of halves.
  add(sum, row.snaps, {{Operation::call, 1}, {Operation::come_back, 1}, {Operation::store_long, 6}});
  price_adds(sum, 6 * row.snaps);
  price_products(sum, 3 * row.snaps);
  return sum;
}

MeshSeconds seconds_of(const MeshRow& row, const processors::Processor& processor) {
  return {processors::seconds(subdividing(row), processor), processors::seconds(repairing(row), processor)};
}

}  // namespace csgsim::studies
