#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::read_test {

/// Reads a text by the name of `m.csg`.
model::Tree read(std::string_view text);

/// A tree, and the warnings that reading it makes.
struct Warned {
  model::Tree tree;
  std::vector<std::string> warnings;
};

Warned read_warned(std::string_view text);

/// The message of the InputError that a text makes; a text that reads well fails the test.
std::string error_of(std::string_view text);

/// The tree in a line, as `difference(cube, union(sphere, cube))`; `nothing` if it is empty. For shallow trees.
std::string outline(const model::Tree& tree);

/// Everything that a tree holds but the places in the file, for comparison.
std::string dump(const model::Tree& tree);

}  // namespace csgsim::read_test
