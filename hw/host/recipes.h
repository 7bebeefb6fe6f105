#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "hw/isa/host_counts.h"
#include "hw/isa/program.h"
#include "hw/processors/operations.h"

/// What a host's processor does for a frame (docs/host.md). How often each thing is done is counted; what each takes is
/// assumed, written out for longs of 32 bits, as a careful programmer would.
namespace csgsim::host {

/// Something that is counted, and what it takes each time.
struct Recipe {
  std::string_view name;  ///< as Programs have it
  std::uint64_t isa::Preparation::*count;
  processors::Operations each;
};

std::span<const Recipe> recipes();

/// What is written, as far as it says what that takes.
struct Written {
  std::uint64_t instructions = 0;
  std::uint64_t numbers = 0;  ///< that they have behind the commands' own
  std::uint64_t linear = 0;   ///< of the instructions, those with a linear expression
  std::uint64_t squares = 0;  ///< the same with squares
  std::uint64_t longs = 0;    ///< that are stored for their words

  /// In words of a link of that many bits.
  void add(const isa::Instruction& instruction, unsigned link_width);
};

/// Expressions are moved to their segments and made as short as they can be, and instructions put together and stored.
processors::Operations operations_of(const Written& written);
processors::Operations operations_of(const isa::Instruction& instruction, unsigned link_width);

/// Of a long of the display model, which is put together from its numbers.
processors::Operations of_model_long();

}  // namespace csgsim::host
