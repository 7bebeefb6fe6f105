#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hw/division/bit_stream.h"
#include "hw/division/divide.h"
#include "tests/support/drawing.h"

namespace csgsim::testing {

/// What both are asked to divide.
struct DivisionCase {
  Setup setup;                   ///< squares, sampling, camera, colouring
  std::uint32_t group_side = 4;  ///< squares of a group, along a row and down
  std::uint64_t list_entries = 1'000'000;
};

/// The setup for a camera and squares, with memory to spare.
Setup squares_of(const view::Camera& camera, const view::Sampling& sampling, machines::Size square,
                 emit::Colouring colouring);

/// A Program that the host compiled for the divider's prunings, and what its display model travels as.
struct ForDivider {
  Compiled host;
  division::Bits sent;
};

/// Compiles a model both ways. Throws InputError where the host refuses it.
ForDivider compile_for_divider(const std::string& text, const Setup& setup);
ForDivider compile_file_for_divider(const std::string& path, const Setup& setup);

/// The first way in which a divider that is given what was sent differs from the host, at one level or two, in
/// instructions or in counts; empty if it does not. Adds what was done at one level to `done`.
std::string difference(const ForDivider& made, const DivisionCase& how, division::Counts& done);

}  // namespace csgsim::testing
