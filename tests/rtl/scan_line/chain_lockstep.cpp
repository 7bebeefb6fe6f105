#include "tests/rtl/scan_line/chain_lockstep.h"

#include <fmt/format.h>

#include <utility>

namespace csgsim::rtl {

namespace {

test::PlainBeat in_first_cell(const scan_line::Beat& beat, const scan_line::CellShape& shape) {
  test::PlainBeat here;
  if (beat.packet == nullptr) return here;
  static_cast<scan_line::Packet&>(here) = *beat.packet;
  here.number = beat.number;
  if (!here.brings_f() || here.number >= here.words) return here;
  const auto [f, a, aa] = scan_line::arriving_words(beat, 0, shape);
  here.f = f;
  here.a = a;
  here.aa = aa;
  return here;
}

}  // namespace

ChainLockstep::ChainLockstep(const machines::Machine& machine)
    : machine_(machine),
      shape_(scan_line::cell_shape(machines::kind_figures<scan_line::Figures>(machine))),
      systemc_(machine),
      plain_(machine.array.width, machine.array.memory_bits, shape_),
      verilog_(std::make_unique<RtlChain>()) {
  for (std::uint32_t i = 0; i < machine.array.width; ++i) cells_.emplace_back(i, shape_, machine);
}

std::string ChainLockstep::run(std::span<const isa::Program> programs, std::uint8_t fault) {
  comparing_ = true;
  clock_ = 0;
  for (CellCheck& cell : cells_) cell.begin();
  draw(programs, fault);
  comparing_ = false;
  std::string difference = std::exchange(difference_, {});
  if (!difference.empty()) clear();
  return difference;
}

void ChainLockstep::draw(std::span<const isa::Program> programs, std::uint8_t fault) {
  for (const isa::Program& program : programs) {
    const isa::FrameHeader header = isa::frame_header(program);
    const scan_line::PictureLines frame{.lines = program.segments,
                                        .extents = program.extents,
                                        .colour = header.colour,
                                        .background = header.background};
    if (frame.pixels() != pixels_) {
      drain(fault);
      pixels_ = frame.pixels();
      systemc_.clear(pixels_);
      worked_.assign(pixels_, {});
      for (CellCheck& cell : cells_) cell.begin();
    }
    systemc_.begin(frame);
    while (!systemc_.is_through()) clock(fault);
  }
  drain(fault);
}

/// Runs until the last mark has left the cells and its line has been shown.
void ChainLockstep::drain(std::uint8_t fault) {
  for (std::uint32_t i = 0; pixels_ > 0 && i < 2 * pixels_ + 3; ++i) clock(fault);
}

void ChainLockstep::clock(std::uint8_t fault) {
  const scan_line::Beat& entry = systemc_.entry();
  worked_.push_front(in_first_cell(entry, shape_));
  worked_.pop_back();
  plain_.step(entry);
  systemc_.clock();
  verilog_->edge(worked_.front(), pixels_, fault);
  ++clock_;
  if (comparing_ && difference_.empty()) compare();
}

void ChainLockstep::compare() {
  ++clocks_compared_;
  const ChainRegisters& registers = verilog_->registers();
  const scan_line::RefreshPixel& refresh = systemc_.refresh();
  if (refresh.valid != registers.refresh_valid || (refresh.valid && refresh.colour != registers.refresh_colour)) {
    difference_ = fmt::format("clock {}: at the refresh port {} {} in SystemC, {} {} in Verilog", clock_, refresh.valid,
                              refresh.colour, registers.refresh_valid, registers.refresh_colour);
    return;
  }
  for (std::uint32_t i = 0; i < pixels_; ++i) {
    const std::string difference = cells_[i].compare(systemc_.chain(), plain_, worked_[i], pixels_, registers);
    if (difference.empty()) continue;
    difference_ = fmt::format("clock {}, cell {}: {}", clock_, i, difference);
    return;
  }
}

/// Clears memory and enable of both after a difference.
void ChainLockstep::clear() {
  isa::Program program;
  program.shape = {machine_.array.width, 1, machine_.array.memory_bits};
  program.segments = {{.region = {0, 0, machine_.array.width, 1}, .instructions = {}}};
  draw({&program, 1}, 0);
  verilog_ = std::make_unique<RtlChain>();
}

}  // namespace csgsim::rtl
