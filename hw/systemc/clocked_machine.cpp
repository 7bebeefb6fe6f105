#include "hw/systemc/clocked_machine.h"

namespace csgsim::systemc {

std::vector<RunReport> ClockedMachine::run_sequence(std::span<const isa::Program> programs,
                                                    std::span<RunListener* const> listeners) {
  std::vector<RunReport> reports;
  for (std::size_t i = 0; i < programs.size(); ++i) reports.push_back(run(programs[i], *listeners[i]));
  return reports;
}

std::vector<wave::Tap> ClockedMachine::taps(const isa::Program& /*program*/, const wave::Request& /*request*/) const {
  return {};
}

std::uint64_t ClockedMachine::skip_to(const isa::Program& /*program*/, wave::Window /*window*/) { return 0; }

}  // namespace csgsim::systemc
