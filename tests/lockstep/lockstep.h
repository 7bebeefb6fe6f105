#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "hw/machines/machine.h"
#include "sim/engine/engine.h"

namespace csgsim::test {

/// Reports the first difference between two engines.
class Difference : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The results of two engines for a Program.
struct Results {
  engine::RunResult judge;
  engine::RunResult engine;
};

/// Runs the Program on both engines. Throws Difference unless they agree at every instruction boundary, in the answers,
/// overflows and clocks, and the clocks equal those of hw/machines and add up. The judge must be able to stop.
Results check_lockstep(engine::Engine& judge, engine::Engine& engine, const isa::Program& program,
                       const machines::Machine& machine);

/// Whether every unit accounts for every clock of the frame.
bool is_account_complete(const engine::RunResult& result);

/// The clocks, and how each unit spent them.
std::string show(const engine::RunResult& result);

/// A machine with arbitrary parameters for that array.
machines::Machine machine_of(isa::ArrayShape shape, std::uint32_t memory_reads, std::uint32_t alu_bits = 1);

}  // namespace csgsim::test
