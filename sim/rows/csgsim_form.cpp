#include <fmt/format.h>

#include <sstream>
#include <utility>

#include "hw/bit_serial_memory/row_text.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "sim/rows/forms.h"

namespace csgsim::rows {

namespace {

using bit_serial_memory::CommandClocks;
using bit_serial_memory::RankClocks;

std::string timing_lines(const CommandClocks& command, const RankClocks& rank) {
  std::string text;
  for (const auto& [name, clocks] :
       std::initializer_list<std::pair<const char*, std::uint32_t>>{{"restore", command.restore},
                                                                    {"precharge", command.precharge},
                                                                    {"second", command.second},
                                                                    {"logic", command.logic},
                                                                    {"column", command.column},
                                                                    {"recovery", command.recovery},
                                                                    {"leaf", command.leaf},
                                                                    {"global_or", command.global_or},
                                                                    {"activation_gap", rank.activation_gap},
                                                                    {"window", rank.window},
                                                                    {"refresh_interval", rank.refresh_interval},
                                                                    {"refresh", rank.refresh}})
    text += fmt::format("timing {} {}\n", name, clocks);
  return text;
}

std::string gate_lines(const bit_serial_memory::CommandSet& set) {
  std::string text;
  for (const bit_serial_memory::GateCommand& command : set.commands) {
    std::string table;
    for (unsigned i = 0; i < 1U << command.inputs; ++i) table += (command.table >> i & 1U) != 0 ? '1' : '0';
    text += fmt::format("gate {} {} {} {}\n", command.name, table, command.clocks, command.energy_fj);
  }
  return text;
}

/// The complete form: commands with all operands, and the data that a replay needs. docs/row-traces.md has its grammar.
class CsgsimForm final : public Form {
 public:
  using Form::Form;

  [[nodiscard]] std::string heading() const override {
    const isa::Program& program = frame().program;
    std::ostringstream text;
    text << fmt::format("csgsim-rows 1\nmachine {}\nclock {}\npicture {} {} {}\n", frame().machine.name,
                        frame().machine.clock_hz, program.shape.width, program.shape.height, program.background);
    if (program.colour.width > 0) text << fmt::format("colour {} {}\n", program.colour.base, program.colour.width);
    text << fmt::format("slots {} {} {}\n", frame().slots.count(), frame().slots.row_columns, frame().slots.banks);
    text << timing_lines(frame().figures.command, frame().figures.rank);
    if (frame().set != nullptr) text << gate_lines(*frame().set);
    bit_serial_memory::print_row_map(text, frame().map);
    return text.str();
  }

  std::string segment(std::uint32_t number) override {
    squares_ = {};
    return fmt::format("segment {}\n", number);
  }

  std::string instruction(std::uint64_t number, const isa::Instruction& instruction) override {
    std::string text = fmt::format("instruction {} {}\n", number, isa::name_of(instruction.opcode));
    const isa::Linear& f = instruction.linear;
    if (f.width > 0) {
      text +=
          fmt::format("expression {} {} {} {} {} {} {}\n", f.width, f.a, f.b, f.c, squares_.a, squares_.b, squares_.c);
    }
    const bool is_squares = isa::has_operand(isa::operands_of(instruction.opcode), isa::OperandKind::squares);
    squares_ = is_squares ? instruction.linear : isa::Linear{};
    return text;
  }

  [[nodiscard]] std::string scan_out() const override { return "scan_out\n"; }

  [[nodiscard]] std::string end(const machines::FrameTiming& timing) const override {
    return fmt::format("end {} {}\n", timing.clocks, timing.shown_clocks);
  }

  void add(const RowCommand& command, const Issue& issue, Lines& lines) const override {
    if (bit_serial_memory::activations(command.op) == 0) {
      lines.push_back({issue.clock, fmt::format("{} {} * - - {}\n", issue.clock, issue.place, text_of(command))});
      return;
    }
    const std::string second = command.op == RowOp::copy ? fmt::format("{}", issue.second) : "-";
    const std::string bus =
        issue.transfer_clocks > 0 ? fmt::format(" bus {} {}", issue.transfer, issue.transfer_clocks) : "";
    lines.push_back(
        {issue.clock, fmt::format("{} {} {} {} {} {}{}\n", issue.clock, frame().slots.bank(issue.place),
                                  issue.place / frame().slots.banks, second, issue.precharge, text_of(command), bus)});
  }

  void add_refresh(std::uint64_t clock, Lines& lines) const override {
    lines.push_back({clock, fmt::format("{} * * - - REFRESH\n", clock)});
  }

  [[nodiscard]] std::string_view instead(RowOp /*op*/) const override { return {}; }
  [[nodiscard]] bool has_all_rows() const override { return true; }

 private:
  isa::Linear squares_;  ///< set by the previous instruction
};

}  // namespace

const FormRow csgsim_form{.name = "csgsim", .make = [](const Frame& frame) -> std::unique_ptr<Form> {
                            return std::make_unique<CsgsimForm>(frame);
                          }};

}  // namespace csgsim::rows
