#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hw/division/bit_stream.h"
#include "hw/division/divide.h"
#include "tests/support/drawing.h"

namespace csgsim::testing {

/// Parameters of a division.
struct DivisionCase {
  Setup setup;                   ///< squares, sampling, camera and colouring
  std::uint32_t group_side = 4;  ///< side of a group in squares
  std::uint64_t list_entries = 1'000'000;
};

/// Setup for a camera and squares, with ample memory.
Setup squares_of(const view::Camera& camera, const view::Sampling& sampling, machines::Size square,
                 emit::Colouring colouring);

/// A Program that the host compiled with the divider's pruning rules, and the encoded display model.
struct ForDivider {
  Compiled host;
  division::Bits sent;
};

/// Compiles a model for the host and for the divider. Throws InputError if the host rejects it.
ForDivider compile_for_divider(const std::string& text, const Setup& setup);
ForDivider compile_file_for_divider(const std::string& path, const Setup& setup);

/// Describes the first difference between host and divider, at one level and at two, in instructions or counts; empty
/// if they agree. Adds the work done at one level to `done`.
std::string difference(const ForDivider& made, const DivisionCase& how, division::Counts& done);

}  // namespace csgsim::testing
