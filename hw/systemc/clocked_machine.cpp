#include "hw/systemc/clocked_machine.h"

#include <stdexcept>

namespace csgsim::kernel {

std::vector<RunReport> ClockedMachine::run_sequence(std::span<const isa::Program> programs,
                                                    std::span<RunListener* const> listeners) {
  std::vector<RunReport> reports;
  for (std::size_t i = 0; i < programs.size(); ++i) reports.push_back(run(programs[i], *listeners[i]));
  return reports;
}

void ClockedMachine::record(const WaveRequest& /*request*/) {
  throw std::logic_error("a machine without waves was to record one");
}

}  // namespace csgsim::kernel
