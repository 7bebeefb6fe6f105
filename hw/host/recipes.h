// Processor operations per task of the host.
// Used by host.cpp and tests.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "hw/isa/host_counts.h"
#include "hw/isa/program.h"
#include "hw/processors/operations.h"

// Operations of a host's processor for a frame (docs/host.md). The frequency of each task is counted; the operations
// per task are assumed, as a careful programmer would write them for longs of 32 bits.
namespace csgsim::host {

/// A counted task with its operations.
struct Recipe {
  std::string_view name;  ///< name in Programs
  std::uint64_t isa::Preparation::*count;
  processors::Operations each;
};

std::span<const Recipe> recipes();

/// Operations of the task with that name, which must exist.
processors::Operations recipe(std::string_view name);

/// Operations of all counted tasks.
processors::Operations count_operations(const isa::Preparation& preparation);

/// Counts of the written instructions that determine the work of writing them.
struct Written {
  std::uint64_t instructions = 0;
  std::uint64_t numbers = 0;  ///< numbers after the opcodes
  std::uint64_t linear = 0;   ///< instructions with a linear expression
  std::uint64_t squares = 0;  ///< instructions with squares
  std::uint64_t longs = 0;    ///< longs stored for the words

  /// Counts an instruction in words of a link of that width.
  void add(const isa::Instruction& instruction, unsigned link_width);
};

/// Operations to move expressions to their segments, minimize their widths, and assemble and store the instructions.
processors::Operations count_operations(const Written& written);
processors::Operations count_operations(const isa::Instruction& instruction, unsigned link_width);

/// Operations to move a linear expression to a region's corner and to find its common trailing zeros and its width.
processors::Operations fitted_expression();

/// Operations to store a long of an assembled command.
processors::Operations stored_long();

/// Longs of the display model.
std::uint64_t model_longs(const isa::Program& program);

/// Operations for one long of the display model, assembled from its numbers.
processors::Operations model_long_operations();

}  // namespace csgsim::host
