#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hw/bit_serial_memory/memory_machine.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/systemc/wave_recorder.h"

namespace csgsim::testing {

/// A memory in SystemC, and what samples its taps.
struct ClockedMemory {
  std::string name;
  machines::Machine machine;
  std::unique_ptr<bit_serial_memory::MemoryMachine> hardware;
  std::unique_ptr<systemc::WaveRecorder> recorder;
};

/// All that the tests of this folder draw on. SystemC elaborates once a process, so that they stand side by side from
/// the first call on, and one of them draws at a time.
const std::vector<ClockedMemory>& clocked_memories();

/// One of 64 pixels with 8 bits each, all in one row, with gates, latches for E and a wired OR: what it takes can be
/// added up by hand.
const ClockedMemory& smallest_memory();

/// What the taps show in the clocks of a window: of each tap a value a clock, of a number in decimal, empty where it
/// shows nothing.
class Recording {
 public:
  /// Draws the Program, whose pixels of the request are shown.
  Recording(const ClockedMemory& memory, const isa::Program& program, const std::vector<wave::Pixel>& pixels,
            wave::Window window);

  /// Throws std::out_of_range if no tap has that name.
  [[nodiscard]] const std::vector<std::string>& of(const std::string& tap) const;
  [[nodiscard]] std::uint64_t count(const std::string& tap, const std::string& value) const;
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  std::vector<std::pair<std::string, std::vector<std::string>>> taps_;
};

}  // namespace csgsim::testing
