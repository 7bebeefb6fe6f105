#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::read_test {

/// Reads a text under the file name `m.csg`.
model::Tree read(std::string_view text);

/// A tree and the warnings from reading it.
struct ReadResult {
  model::Tree tree;
  std::vector<std::string> warnings;
};

ReadResult read_with_warnings(std::string_view text);

/// Returns the message of the InputError for a text; fails the test if the text is valid.
std::string error_of(std::string_view text);

/// The tree in a line, as `difference(cube, union(sphere, cube))`; `nothing` if it is empty. For shallow trees.
std::string outline(const model::Tree& tree);

/// All contents of a tree except places in the file, for comparison.
std::string dump(const model::Tree& tree);

}  // namespace csgsim::read_test
