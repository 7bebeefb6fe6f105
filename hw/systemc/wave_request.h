#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::kernel {

struct WaveProbe {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
};

/// What to record of a run.
struct WaveRequest {
  std::filesystem::path file;  ///< ends in .vcd
  std::uint64_t begin = 0;     ///< first clock recorded; clock 0 has the program's first step on the wires
  std::uint64_t end = 0;       ///< first clock no longer recorded
  std::vector<WaveProbe> probes;
  std::vector<isa::NamedField> fields;  ///< of every probe's memory
};

/// A field's name as the file has it: one identifier for every wave viewer.
std::string wave_identifier(std::string_view name);

}  // namespace csgsim::kernel
