// The text form in which the benchmark suite stores Programs.
// Used by sim/suite and sim/app.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "hw/isa/program.h"

namespace csgsim::suite {

/// The Program in text form (hw/isa/text.h) without what no machine acts on: the record of its machine, facts about the
/// model and its compilation, origins and comments. The scale of depths and the names of fields stay.
std::string text_of(const isa::Program& program);

/// Number of bits of pixel memory that an instruction or the displayed picture reads or writes.
std::uint32_t used_bits(const isa::Program& program);

}  // namespace csgsim::suite
