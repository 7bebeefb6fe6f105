#include "hw/kinds/make.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>

#include "hw/base/error.h"
#include "hw/systemc/maker.h"

namespace csgsim::kinds {

namespace {

const systemc::Maker& find_maker(const machines::Machine& machine) {
  const std::span<const systemc::Maker* const> all = systemc::makers();
  const auto found = std::ranges::find(all, machine.kind, &systemc::Maker::kind);
  if (found == all.end()) throw std::logic_error("a machine of a kind that is not in the table");
  return **found;
}

}  // namespace

std::unique_ptr<systemc::ClockedMachine> make_clocked_machine(const machines::Machine& machine,
                                                              systemc::EvaluatorForm form) {
  if (form == systemc::EvaluatorForm::computed) return find_maker(machine).make(machine);
  if (can_be_stepped(machine)) return find_maker(machine).make_stepped(machine);
  throw InputError("a machine of kind " + std::string(machine.kind->name) +
                   " has no multiplier trees that can be stepped; use one of kind frame-buffer or pixel-square, or "
                   "computed trees");
}

bool can_be_stepped(const machines::Machine& machine) { return find_maker(machine).make_stepped != nullptr; }

bool can_be_probed(const machines::Machine& machine) { return find_maker(machine).make_probed != nullptr; }

std::unique_ptr<systemc::ClockedMachine> make_probed_machine(const machines::Machine& machine,
                                                             const systemc::EarlierRun& earlier,
                                                             systemc::EvaluatorForm form) {
  return find_maker(machine).make_probed(machine, earlier, form);
}

}  // namespace csgsim::kinds
