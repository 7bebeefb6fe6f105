#include "hw/bit_serial_memory/memory_machine.h"

#include <algorithm>
#include <string>

#include "hw/base/error.h"
#include "hw/bit_serial_memory/account.h"
#include "hw/bit_serial_memory/kind.h"
#include "hw/bit_serial_memory/taps.h"
#include "hw/link/frame_words.h"
#include "hw/systemc/kernel.h"
#include "hw/systemc/maker.h"

namespace csgsim::bit_serial_memory {

namespace {

bool is_drawn(const isa::Program& program) {
  return std::ranges::any_of(program.segments,
                             [](const isa::Segment& segment) { return !segment.instructions.empty(); });
}

}  // namespace

std::vector<const Bank*> MemoryMachine::make_banks() {
  std::vector<const Bank*> all;
  for (std::uint32_t i = 0; i < slots_.used_banks(); ++i) {
    const std::string name = "bank_" + std::to_string(i);
    Bank& bank = banks_.emplace_back(name.c_str(), i, slots_, map_, machine_.picture.width);
    bank.expression(expression_);
    all.push_back(&bank);
  }
  return all;
}

MemoryMachine::MemoryMachine(sc_core::sc_module_name name, const machines::Machine& machine)
    : sc_core::sc_module(name),
      machine_(machine),
      figures_(machines::kind_figures<Figures>(machine)),
      slots_(slots_of(machine)),
      map_(machine.array.memory_bits, machine.picture.width, machine.picture.height),
      period_(systemc::period_of(machine)),
      queue_("queue", figures_.queue),
      host_("host", machine.link, period_),
      expression_("expression", slots_, machine.picture.width),
      bank_list_(make_banks()),
      pixels_(bank_list_, slots_, machine.picture.width, map_,
              figures_.design == Design::latches && figures_.enable_latch),
      controller_("controller", figures_, slots_, map_, machine.link.width, period_),
      completion_("completion", pixels_) {
  sc_core::sc_report_handler::set_actions(sc_core::SC_WARNING, sc_core::SC_THROW);
  host_.requests(requests_);
  host_.queue(queue_);
  controller_.queue(queue_);
  controller_.requests(requests_);
  for (Bank& bank : banks_) controller_.banks(bank);
  controller_.expression(expression_);
  controller_.progress(completion_);
  completion_.retirement(retirement_);
  controller_.on_sent_row([this](unsigned bit) { collect(bit); });
}

void MemoryMachine::check(const isa::Program& program) const {
  const bool fits = program.shape.width == machine_.picture.width && program.shape.height == machine_.picture.height &&
                    program.shape.memory_bits <= machine_.array.memory_bits;
  if (fits) return;
  throw InputError(
      "the Program needs another picture size or more pixel memory than the machine has; compile it for this machine");
}

/// Receives a row of the colour field from the sense amplifiers at the host.
void MemoryMachine::collect(unsigned bit) {
  for (std::uint64_t pixel = 0; pixel < slots_.pixels; ++pixel) {
    const std::uint64_t slot = pixel / slots_.row_columns;
    const std::uint64_t column = pixel % slots_.row_columns;
    const std::span<const std::uint64_t> row = bank_list_[slots_.bank(slot)]->subarray(slot).sent();
    picture_[pixel] |= static_cast<std::uint32_t>(row[column / 64] >> column % 64 & 1U) << bit;
  }
}

systemc::RunReport MemoryMachine::run(const isa::Program& program, systemc::RunListener& listener) {
  check(program);
  systemc::elaborate();
  const isa::FrameHeader header = isa::frame_header(program);
  const bool shows = header.colour.width > 0;
  const bool drawn = is_drawn(program);
  picture_.assign(shows ? slots_.pixels : 0, drawn ? 0 : header.background);
  for (Bank& bank : banks_) bank.begin();
  queue_.clear();
  retirement_.begin(listener);
  completion_.begin(program.segments);
  host_.load(link::frame_words(program, machine_.link.width));
  controller_.begin(shows && drawn, [this] { return pixels_.count_enabled() > 0; });
  systemc::run();
  if (!systemc::is_stopped()) retirement_.rethrow();
  return report();
}

Work MemoryMachine::work() const {
  Work all;
  all.commands = controller_.commands();
  all.refreshes = controller_.refreshes();
  for (const Bank& bank : banks_) {
    all.activations += bank.work().activations;
    all.further_rows += bank.work().further_rows;
    all.logic += bank.work().logic;
    all.leaves += bank.work().leaves;
    all.transferred_bits += bank.work().transferred_bits;
  }
  return all;
}

systemc::RunReport MemoryMachine::report() const {
  const FrameAccount frame{.controller = controller_.account(),
                           .sending = host_.sending(),
                           .scan_out_clocks = controller_.shown_clocks() - controller_.clocks(),
                           .work = work()};
  systemc::RunReport result{.clocks = controller_.clocks(), .answers = completion_.answers()};
  result.skipped = completion_.skipped();
  result.shown_clocks = controller_.shown_clocks();
  result.interval_clocks = controller_.shown_clocks();
  result.account = account(frame, controller_.clocks(), controller_.shown_clocks(), machine_);
  result.picture = picture_;
  return result;
}

std::vector<wave::Tap> MemoryMachine::taps(const isa::Program& program, const wave::Request& request) const {
  return machine_taps({controller_, host_, bank_list_, pixels_, slots_, machine_.picture.width}, program, request);
}

}  // namespace csgsim::bit_serial_memory

namespace csgsim::systemc {

extern const Maker bit_serial_memory_maker{
    .kind = &bit_serial_memory::kind, .make = [](const machines::Machine& machine) -> std::unique_ptr<ClockedMachine> {
      return std::make_unique<bit_serial_memory::MemoryMachine>("bit_serial_memory", machine);
    }};

}  // namespace csgsim::systemc
