#include <cstdint>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/cycle/clocked_engine.h"
#include "sim/engine/engine.h"
#include "sim/session/run/run_request.h"

namespace csgsim::session {

namespace {

enum class Level : std::uint8_t { functional, cycle, reference };

const std::map<std::string, Level> levels{
    {"functional", Level::functional}, {"cycle", Level::cycle}, {"reference", Level::reference}};

}  // namespace

std::vector<std::string> level_names() {
  std::vector<std::string> names;
  names.reserve(levels.size());
  for (const auto& [name, level] : levels) names.push_back(name);
  return names;
}

std::unique_ptr<engine::Engine> make_engine(const machines::Machine& machine, const std::string& level,
                                            unsigned threads, systemc::EvaluatorForm form) {
  switch (levels.at(level)) {
    case Level::functional: return engine::make_functional_engine(machine, threads);
    case Level::cycle: return cycle::make_clocked_engine(machine, cycle::clocked_hardware(machine, form));
    case Level::reference: return engine::make_reference_engine(machine);
  }
  throw std::logic_error("a level without an engine");
}

}  // namespace csgsim::session
