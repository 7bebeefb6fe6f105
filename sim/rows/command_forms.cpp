#include <fmt/format.h>

#include "sim/rows/address.h"
#include "sim/rows/forms.h"

namespace csgsim::rows {

namespace {

enum class DramOp : std::uint8_t { activate, precharge, read, write };

/// A command of an ordinary DRAM.
struct DramCommand {
  DramOp op = DramOp::activate;
  std::uint64_t clock = 0;
  std::uint32_t bank = 0;
  std::uint32_t row = 0;
  std::uint32_t column = 0;
};

/// Forms that list the commands of an ordinary DRAM: activations and precharges at their clocks, and the bursts of
/// transferred rows.
class CommandForm : public Form {
 public:
  using Form::Form;

  void add(const RowCommand& command, const Issue& issue, Lines& lines) const final {
    if (bit_serial_memory::activations(command.op) == 0) return;
    const auto emit = [&](const DramCommand& one) { lines.push_back({one.clock, text(one)}); };
    const std::uint32_t bank = frame().slots.bank(issue.place);
    const auto row = [&](const bit_serial_memory::WordLines& lines_raised) {
      return row_in_bank(lines_raised.begin()->row, issue.place, frame());
    };
    const std::uint32_t first = row(command.from.count > 0 ? command.from : command.to);
    emit({DramOp::activate, issue.clock, bank, first, 0});
    if (command.op == RowOp::copy) emit({DramOp::activate, issue.second, bank, row(command.to), 0});
    if (issue.transfer_clocks > 0) {
      const DramOp op = command.op == RowOp::send ? DramOp::read : DramOp::write;
      std::uint32_t column = 0;
      for (const std::uint64_t clock : burst_commands(issue, frame())) {
        emit({op, clock, bank, first, column});
        column += burst_columns;
      }
    }
    emit({DramOp::precharge, issue.precharge, bank, first, 0});
  }

  void add_refresh(std::uint64_t clock, Lines& lines) const final { lines.push_back({clock, refresh_text(clock)}); }

  [[nodiscard]] std::string_view instead(RowOp op) const final {
    switch (op) {
      case RowOp::copy: return "ACT, ACT and PRE";
      case RowOp::latch:
      case RowOp::read:
      case RowOp::write:
      case RowOp::leaf_copy: return "ACT and PRE";
      case RowOp::logic:
      case RowOp::leaf:
      case RowOp::wired_or: return "nothing";
      case RowOp::activate:
      case RowOp::receive:
      case RowOp::send: return {};
    }
    return {};
  }

 protected:
  [[nodiscard]] virtual std::string text(const DramCommand& command) const = 0;
  [[nodiscard]] virtual std::string refresh_text(std::uint64_t clock) const = 0;
};

std::string_view jedec_name(DramOp op) {
  switch (op) {
    case DramOp::activate: return "ACT";
    case DramOp::precharge: return "PRE";
    case DramOp::read: return "RD";
    case DramOp::write: return "WR";
  }
  return {};
}

/// The command trace of DRAMPower 5 and 6. A bank is counted in the whole rank. The data of bursts are zeros.
class DrampowerForm final : public CommandForm {
 public:
  using CommandForm::CommandForm;

  [[nodiscard]] std::string end(const machines::FrameTiming& timing) const override {
    return fmt::format("{},END,0,0,0,0,0\n", timing.shown_clocks);
  }

 protected:
  [[nodiscard]] std::string text(const DramCommand& command) const override {
    const bool is_burst = command.op == DramOp::read || command.op == DramOp::write;
    const std::string data = is_burst ? "," + std::string(2 * burst_bytes(frame()), '0') : "";
    return fmt::format("{},{},0,{},{},{},{}{}\n", command.clock, jedec_name(command.op), group_of(command.bank),
                       command.bank, command.row, command.column, data);
  }
  [[nodiscard]] std::string refresh_text(std::uint64_t clock) const override {
    return fmt::format("{},REFA,0,0,0,0,0\n", clock);
  }
};

/// The command trace of DRAMPower 4, without rows.
class Drampower4Form final : public CommandForm {
 public:
  using CommandForm::CommandForm;

  [[nodiscard]] std::string end(const machines::FrameTiming& timing) const override {
    return fmt::format("{},END,0\n", timing.shown_clocks);
  }

 protected:
  [[nodiscard]] std::string text(const DramCommand& command) const override {
    return fmt::format("{},{},{}\n", command.clock, jedec_name(command.op), command.bank);
  }
  [[nodiscard]] std::string refresh_text(std::uint64_t clock) const override {
    return fmt::format("{},REF,0\n", clock);
  }
};

/// The command trace that Ramulator 2.1 records. Levels that do not apply to a command are -1.
class Ramulator2Form final : public CommandForm {
 public:
  using CommandForm::CommandForm;

  [[nodiscard]] std::string heading() const override {
    return "clock,command,Channel,Rank,BankGroup,Bank,Row,Column,type,source\n";
  }

 protected:
  [[nodiscard]] std::string text(const DramCommand& command) const override {
    const std::string bank = fmt::format("0,0,{},{}", group_of(command.bank), bank_in_group(command.bank));
    switch (command.op) {
      case DramOp::activate: return fmt::format("{},ACT,{},{},-1,-1,-1\n", command.clock, bank, command.row);
      case DramOp::precharge: return fmt::format("{},PREpb,{},-1,-1,-1,-1\n", command.clock, bank);
      case DramOp::read: return fmt::format("{},RD,{},{},{},0,-1\n", command.clock, bank, command.row, command.column);
      case DramOp::write: return fmt::format("{},WR,{},{},{},1,-1\n", command.clock, bank, command.row, command.column);
    }
    return {};
  }
  [[nodiscard]] std::string refresh_text(std::uint64_t clock) const override {
    return fmt::format("{},REFab,0,0,-1,-1,-1,-1,-1,-1\n", clock);
  }
};

template <class Made>
std::unique_ptr<Form> make(const Frame& frame) {
  return std::make_unique<Made>(frame);
}

}  // namespace

const FormRow ramulator2_form{.name = "ramulator2", .make = make<Ramulator2Form>};
const FormRow drampower_form{.name = "drampower", .make = make<DrampowerForm>};
const FormRow drampower4_form{.name = "drampower4", .make = make<Drampower4Form>};

}  // namespace csgsim::rows
