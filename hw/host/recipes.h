#pragma once

#include <cstdint>
#include <span>
#include <string_view>

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

/// Of an instruction: its expression is moved to its segment and made as short as it can be, and the instruction is put
/// together and stored, in words of a link of that many bits.
processors::Operations operations_of(const isa::Instruction& instruction, unsigned link_width);

/// Of a long of the display model, which is put together from its numbers.
processors::Operations of_model_long();

}  // namespace csgsim::host
