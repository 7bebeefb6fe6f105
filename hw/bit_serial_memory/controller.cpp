#include "hw/bit_serial_memory/controller.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "hw/isa/operands.h"
#include "hw/systemc/kernel.h"

namespace csgsim::bit_serial_memory {

Controller::Controller(sc_core::sc_module_name name, const Figures& figures, const Slots& slots, const RowMap& map,
                       unsigned link_width, const sc_core::sc_time& period)
    : sc_core::sc_module(name), figures_(figures), slots_(slots), map_(map), period_(period), decoder_(link_width) {
  SC_HAS_PROCESS(Controller);
  SC_THREAD(work);
}

void Controller::begin(bool shows, std::function<bool()> answer) {
  shows_ = shows;
  answer_ = std::move(answer);
  start_.notify(sc_core::SC_ZERO_TIME);
}

void Controller::work() {
  while (true) {
    state_ = "";
    wait(start_);
    wait(period_);
    draw();
    sc_core::sc_pause();
  }
}

std::uint64_t Controller::edge() const { return (sc_core::sc_time_stamp() - origin_).value() / period_.value(); }

void Controller::wait_until(const sc_core::sc_time& edge) {
  if (edge > sc_core::sc_time_stamp()) wait(edge - sc_core::sc_time_stamp());
}

void Controller::draw() {
  origin_ = sc_core::sc_time_stamp();
  due_ = origin_ + time_of(figures_.rank.refresh_interval);
  account_ = {};
  commands_ = {};
  refreshes_ = 0;
  next_ordinal_ = 0;
  ended_ = false;
  jumped_ = false;
  cleared_ = false;
  requests->nb_write(0);
  while (!ended_) {
    const isa::Command command = next_command();
    std::visit([this](const auto& one) { begin(one); }, command);
    ordinal_.reset();
  }
}

/// Waits for a command; performs refreshes that fall due meanwhile.
isa::Command Controller::next_command() {
  std::uint64_t& waiting = jumped_ ? account_.jumping : account_.starved;
  state_ = "waiting";
  while (true) {
    const sc_core::sc_time now = systemc::now();
    const std::uint64_t since = edge();
    if (figures_.rank.refresh_interval > 0 && due_ <= now) {
      refresh_idle();
      continue;
    }
    const LinkedCommand* const front = queue->front();
    if (front != nullptr && front->arrived + period_ <= now) break;
    const sc_core::sc_time ready = front == nullptr ? sc_core::sc_max_time() : front->arrived + period_;
    const sc_core::sc_time due = figures_.rank.refresh_interval > 0 ? due_ : sc_core::sc_max_time();
    const sc_core::sc_time next = std::min(ready, due);
    if (next == sc_core::sc_max_time())
      wait(queue->command_arrived());
    else
      wait(next - now, queue->command_arrived());
    waiting += edge() - since;
  }
  jumped_ = false;
  std::optional<isa::Command> command;
  for (const isa::LinkWord& word : queue->take().words) command = decoder_.take(word);
  return *command;
}

void Controller::refresh_idle() {
  state_ = "refreshing";
  refresh();
  account_.refreshing += figures_.rank.refresh;
  state_ = "waiting";
}

void Controller::begin(const isa::SegmentStart& /*start*/) {
  state_ = "clearing";
  const std::uint64_t start_clock = edge();
  const std::uint64_t refreshing = account_.refreshing;
  squares_ = {};
  carry_out(clear_program(map_, micro_design(figures_)));
  account_.clearing += edge() - start_clock - (account_.refreshing - refreshing);
  cleared_ = true;
  progress->after_clear();
}

void Controller::begin(const isa::Instruction& instruction) {
  state_ = "issuing";
  ordinal_ = next_ordinal_++;
  const std::uint64_t start_clock = edge();
  const std::uint64_t refreshing = account_.refreshing;
  progress->before_instruction();
  expression->begin(instruction.linear, squares_);
  const bool is_squares = isa::has_operand(isa::operands_of(instruction.opcode), isa::OperandKind::squares);
  squares_ = is_squares ? instruction.linear : isa::Linear{};
  carry_out(micro_program(instruction, map_, micro_design(figures_)));
  if (isa::needs_global_or(instruction.opcode)) return answer_question(instruction, start_clock, refreshing);
  const std::uint64_t clocks = edge() - start_clock - (account_.refreshing - refreshing);
  account_.issuing += clocks;
  progress->after_instruction(clocks, std::nullopt, 0);
}

void Controller::answer_question(const isa::Instruction& question, std::uint64_t start_clock,
                                 std::uint64_t refreshing) {
  const std::uint64_t clocks = edge() - start_clock - (account_.refreshing - refreshing);
  account_.answering += clocks;
  const bool any = answer_();
  const std::uint64_t skipped = isa::skipped_instruction_count(question, any ? 1 : 0);
  const bool needs_answer = !isa::has_operand(isa::operands_of(question.opcode), isa::OperandKind::count);
  progress->after_instruction(clocks, needs_answer ? std::optional(any) : std::nullopt, skipped);
  if (skipped == 0) return;
  next_ordinal_ += skipped;
  queue->flush();
  requests->nb_write(next_ordinal_);
  jumped_ = true;
}

void Controller::begin(const isa::FrameEnd& end) {
  ended_ = true;
  clocks_ = edge();
  shown_clocks_ = clocks_;
  if (shows_) scan_out(end.colour);
}

/// Refreshes during scan-out do not count towards drawing the frame.
void Controller::scan_out(isa::Field colour) {
  state_ = "scanning out";
  const std::uint64_t refreshing = account_.refreshing;
  settle();
  unsigned bit = 0;
  const RowCommands commands = send_program(colour);
  for (const RowCommand& command : commands) {
    refresh_before(command);
    issue(command);
    on_sent_row_(bit++);
  }
  wait_until(std::max(all_closed(), guard_.idle()));
  started_.clear();
  account_.refreshing = refreshing;
  shown_clocks_ = edge();
}

/// Synchronizes the banks: all are closed now, and begin together.
void Controller::settle() {
  const sc_core::sc_time now = systemc::now();
  for (std::uint32_t bank = 0; bank < slots_.used_banks(); ++bank) banks[static_cast<int>(bank)]->hold_until(now);
  bus_ = std::max(bus_, now);
}

void Controller::carry_out(const RowCommands& commands) {
  wait(period_);
  settle();
  for (const RowCommand& command : commands) {
    refresh_before(command);
    issue(command);
  }
  wait_until(std::max(all_closed(), guard_.idle()));
  started_.clear();
}

sc_core::sc_time Controller::all_closed() const {
  sc_core::sc_time closed = bus_;
  for (std::uint32_t bank = 0; bank < slots_.used_banks(); ++bank)
    closed = std::max(closed, banks[static_cast<int>(bank)]->free());
  return closed;
}

/// If the command may begin with a refresh, first performs the refreshes that are due, after closing all banks.
/// Everything in progress is delayed.
void Controller::refresh_before(const RowCommand& command) {
  if (figures_.rank.refresh_interval == 0 || !begins_closed(command.op)) return;
  wait_until(std::max(banks[0]->free(), guard_.allowed()));
  const sc_core::sc_time start_time = systemc::now();
  if (start_time < due_) return;
  const std::string_view before = std::exchange(state_, "refreshing");
  wait_until(all_closed());
  while (due_ <= sc_core::sc_time_stamp()) refresh();
  const sc_core::sc_time taken = sc_core::sc_time_stamp() - start_time;
  for (std::uint32_t bank = 0; bank < slots_.used_banks(); ++bank) banks[static_cast<int>(bank)]->delay(taken);
  guard_.delay(taken);
  bus_ += taken;
  account_.refreshing += taken.value() / period_.value();
  state_ = before;
}

/// Requires all banks to be closed.
void Controller::refresh() {
  wait(time_of(figures_.rank.refresh));
  due_ += time_of(figures_.rank.refresh_interval);
  ++refreshes_;
}

void Controller::issue(const RowCommand& command) {
  ++commands_[static_cast<std::size_t>(command.op)];
  const auto in_all = [&](std::uint64_t clocks) {
    started_.add(command, banks[0]->free());
    for (std::uint32_t bank = 0; bank < slots_.used_banks(); ++bank)
      banks[static_cast<int>(bank)]->carry_out_in_all(command, time_of(clocks));
  };
  switch (command.op) {
    case RowOp::logic: return in_all(figures_.command.logic);
    case RowOp::leaf: return in_all(std::max(figures_.command.logic, figures_.command.leaf));
    case RowOp::wired_or: return in_all(figures_.command.global_or);
    case RowOp::copy:
    case RowOp::activate:
    case RowOp::latch:
    case RowOp::read:
    case RowOp::write:
    case RowOp::leaf_copy:
    case RowOp::receive:
    case RowOp::send:
      for (std::uint64_t slot = 0; slot < slots_.count(); ++slot) issue_to_slot(command, slot);
      return;
  }
}

void Controller::activate_at(std::uint64_t slot) {
  wait_until(std::max(banks[static_cast<int>(slots_.bank(slot))]->free(), guard_.allowed()));
  guard_.activate();
}

void Controller::issue_to_slot(const RowCommand& command, std::uint64_t slot) {
  const CommandClocks& clocks = figures_.command;
  const std::uint64_t cycle = std::uint64_t{clocks.restore} + clocks.precharge;
  BankPort& bank = *banks[static_cast<int>(slots_.bank(slot))];
  activate_at(slot);
  if (slot == 0) started_.add(command, sc_core::sc_time_stamp());
  if (command.op == RowOp::receive || command.op == RowOp::send) return transfer(command, slot);
  if (command.op == RowOp::copy) {
    const sc_core::sc_time second = std::max(sc_core::sc_time_stamp() + time_of(clocks.second), guard_.allowed());
    bank.hold_until(second);
    wait_until(second);
    guard_.activate();
  }
  const std::uint64_t taken = command.op == RowOp::leaf_copy ? std::max<std::uint64_t>(cycle, clocks.leaf) : cycle;
  bank.carry_out(command, slot, sc_core::sc_time_stamp() + time_of(taken));
}

void Controller::transfer(const RowCommand& command, std::uint64_t slot) {
  const CommandClocks& clocks = figures_.command;
  const sc_core::sc_time now = systemc::now();
  bus_ = std::max(bus_, now + time_of(clocks.column)) + time_of(transfer_clocks(slots_.columns(slot), figures_));
  const sc_core::sc_time closing = std::max(now + time_of(clocks.restore), bus_ + time_of(clocks.recovery));
  banks[static_cast<int>(slots_.bank(slot))]->carry_out(command, slot, closing + time_of(clocks.precharge));
}

}  // namespace csgsim::bit_serial_memory
