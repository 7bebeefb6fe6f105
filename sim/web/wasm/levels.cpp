// Replaces sim/session/run/levels.cpp without the cycle level, which needs SystemC.
#include "sim/engine/engine.h"
#include "sim/session/run/run_request.h"

namespace csgsim::session {

std::vector<std::string> level_names() { return {"functional", "reference"}; }

std::unique_ptr<engine::Engine> make_engine(const machines::Machine& machine, const std::string& level,
                                            unsigned threads, systemc::EvaluatorForm /*form*/) {
  return level == "reference" ? engine::make_reference_engine(machine)
                              : engine::make_functional_engine(machine, threads);
}

}  // namespace csgsim::session
