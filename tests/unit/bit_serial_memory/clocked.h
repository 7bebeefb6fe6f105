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

/// A memory in SystemC with the recorder of its taps.
struct ClockedMemory {
  std::string name;
  machines::Machine machine;
  std::unique_ptr<bit_serial_memory::MemoryMachine> hardware;
  std::unique_ptr<systemc::WaveRecorder> recorder;
};

/// All memories that the tests of this directory use. SystemC elaborates once per process, so all are built together at
/// the first call; only one runs at a time.
const std::vector<ClockedMemory>& clocked_memories();

/// A memory of 64 pixels with 8 bits each, all in one row, with gates, latches for E and a wired OR: its clocks can be
/// calculated by hand.
const ClockedMemory& smallest_memory();

/// Values of the taps in a window: one value per tap and clock, numbers in decimal, empty where a tap shows nothing.
class Recording {
 public:
  /// Runs the Program and records the given pixels.
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
