#include "hw/bit_serial_memory/account.h"

#include <cmath>
#include <numeric>

#include "hw/bit_serial_memory/figures.h"

namespace csgsim::bit_serial_memory {

void add(const RowCommand& command, std::uint64_t slots, std::uint64_t pixels, Work& work) {
  ++work.commands[static_cast<std::size_t>(command.op)];
  work.activations += activations(command.op) * slots;
  if (command.from.count > 1) work.further_rows += (command.from.count - 1U) * slots;
  if (command.to.count > 1) work.further_rows += (command.to.count - 1U) * slots;
  if (command.op == RowOp::logic) work.logic += slots;
  if (command.own != nullptr) {
    work.own_logic += slots;
    work.own_logic_fj += command.own->energy_fj * slots;
  }
  if (command.op == RowOp::leaf || command.op == RowOp::leaf_copy) work.leaves += slots;
  if (command.op == RowOp::receive || command.op == RowOp::send) work.transferred_bits += pixels;
}

namespace {

std::uint64_t picojoules(double femtojoules) { return static_cast<std::uint64_t>(std::llround(femtojoules / 1000)); }

}  // namespace

FrameEnergy energy_of(const Work& work, std::uint64_t clocks, const machines::Machine& machine) {
  const auto& figures = machines::kind_figures<Figures>(machine);
  const auto number = [](std::uint64_t of) { return static_cast<double>(of); };
  const double activation = number(figures.energy.activation_fj) * figures.chips;
  const double seconds = number(clocks) / number(machine.clock_hz);
  const double columns = number(figures.row_bits) * figures.chips;
  constexpr double fj_per_uj = 1e9;
  return {
      .activation = picojoules(activation * (number(work.activations) +
                                             number(work.further_rows) * figures.energy.further_row_permille / 1000)),
      .logic = picojoules(columns * (number(figures.energy.logic_fj) * number(work.logic - work.own_logic) +
                                     number(work.own_logic_fj))),
      .leaf = picojoules(number(figures.energy.leaf_fj) * columns * number(work.leaves)),
      .transfer = picojoules(number(figures.energy.transfer_fj) * number(work.transferred_bits)),
      .refresh = picojoules(number(figures.energy.refresh_fj) * figures.chips * number(work.refreshes)),
      .background = picojoules(number(figures.energy.background_uw) * figures.chips * seconds * fj_per_uj)};
}

machines::Account account(const FrameAccount& account, std::uint64_t clocks, std::uint64_t shown_clocks,
                          const machines::Machine& machine) {
  const Work& work = account.work;
  const std::uint64_t commands = std::accumulate(work.commands.begin(), work.commands.end(), std::uint64_t{0});
  const FrameEnergy energy = energy_of(work, shown_clocks, machine);
  const ControllerAccount& controller = account.controller;
  machines::Account result{
      .counts = {{"row_commands", commands},
                 {"activations", work.activations},
                 {"further_rows", work.further_rows},
                 {"logic_commands", work.logic},
                 {"leaf_commands", work.leaves},
                 {"transferred_bits", work.transferred_bits},
                 {"refreshes", work.refreshes},
                 {"scan_out_clocks", account.scan_out_clocks},
                 {"activation_picojoules", energy.activation},
                 {"logic_picojoules", energy.logic},
                 {"leaf_picojoules", energy.leaf},
                 {"transfer_picojoules", energy.transfer},
                 {"refresh_picojoules", energy.refresh},
                 {"background_picojoules", energy.background},
                 {"frame_picojoules", energy.sum()}},
      .shares = {{"controller_utilisation", controller.issuing + controller.answering + controller.clearing, clocks},
                 {"link_utilisation", account.sending, clocks}},
      .parts = {{"controller",
                 {{"issuing", controller.issuing},
                  {"answering", controller.answering},
                  {"clearing", controller.clearing},
                  {"refreshing", controller.refreshing},
                  {"starved", controller.starved},
                  {"jumping", controller.jumping}}},
                {"host link", {{"sending", account.sending}, {"waiting", clocks - account.sending}}}}};
  return result;
}

}  // namespace csgsim::bit_serial_memory
