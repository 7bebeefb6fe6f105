#include "hw/scan_line/packet_queue.h"

#include <algorithm>
#include <variant>

#include "hw/isa/opcodes.h"
#include "hw/scan_line/timing.h"

namespace csgsim::scan_line {

PacketQueue::PacketQueue(sc_core::sc_module_name name, const machines::Machine& machine, std::uint32_t chain)
    : systemc::ClockedModule(name),
      machine_(machine),
      figures_(machines::kind_figures<Figures>(machine)),
      cell_(cell_shape(figures_)),
      chain_(chain),
      receiver_(machine.link.width) {}

void PacketQueue::begin(const PictureLines& frame) {
  frame_ = frame;
  budget_ = line_budget(machine_, static_cast<std::uint32_t>(frame.lines.size()));
  line_ = chain_;
  index_ = 0;
  squares_ = {};
  begins_line_ = false;
  beat_.reset();
  line_clocks_ = 0;
  counts_ = {};
  counter_.begin();
}

void PacketQueue::on_clock() {
  busy.write(!all_marks_entered());
  ++line_clocks_;
  ++mark_clocks_;
  if (!beat_ && receiver_.holds()) take(receiver_.take());
  counter_.edge(act());
  receiver_.clock(link);
}

LineActivity PacketQueue::act() {
  if (!beat_ || !may_enter()) {
    entry.write({});
    if (beat_) return LineActivity::waiting_for_refresh;
    return all_marks_entered() ? LineActivity::done : LineActivity::waiting_for_link;
  }
  entry.write(*beat_);
  if (beat_->last()) {
    end_packet();
  } else {
    ++beat_->number;
  }
  return LineActivity::entering;
}

void PacketQueue::take(const isa::Command& command) {
  if (std::holds_alternative<isa::SegmentStart>(command)) {
    begins_line_ = true;
    if (machine_.clear_clocks > 0) take_packet(clear_packet(machine_.clear_clocks));
  } else if (const auto* const instruction = std::get_if<isa::Instruction>(&command)) {
    take_packet(instruction_packet(*instruction, cell_, squares_));
    squares_ = instruction->opcode == isa::Opcode::squares ? instruction->linear : isa::Linear{};
    packets_.at(packet_).keep = retirement->required_after(static_cast<std::uint32_t>(line_), index_);
  } else if (std::holds_alternative<isa::SegmentEnd>(command)) {
    take_packet(index_ > 0 ? mark_packet(frame_.colour, cell_)
                           : background_packet(frame_.colour, frame_.background, cell_));
    packets_.at(packet_).keep = systemc::Keep::all;
  }
}

void PacketQueue::take_packet(const Packet& packet) {
  packet_ = 1 - packet_;
  Packet& taken = packets_.at(packet_);
  taken = packet;
  taken.begins_line = begins_line_ && packet.kind != PacketKind::clear;
  taken.segment = static_cast<std::uint32_t>(line_);
  taken.index = index_;
  begins_line_ = false;
  beat_ = {.packet = &taken, .number = 0};
}

/// A mark must be late enough that its last beat keeps the required distance.
bool PacketQueue::may_enter() const {
  if (beat_->packet->kind != PacketKind::mark || !marked_) return true;
  return mark_clocks_ + beat_->packet->beats - beat_->number > mark_spacing(frame_.pixels());
}

void PacketQueue::end_packet() {
  const Packet& packet = *beat_->packet;
  beat_.reset();
  if (packet.kind == PacketKind::clear) return;
  accounts.nb_write({.clocks = packet.beats});
  if (packet.kind == PacketKind::mark) return end_line();
  ++index_;
  ++counts_.packets;
}

void PacketQueue::end_line() {
  counts_.max_packets = std::max<std::uint64_t>(counts_.max_packets, index_);
  if (line_clocks_ > budget_) ++counts_.late_lines;
  line_clocks_ = 0;
  mark_clocks_ = 0;
  marked_ = true;
  index_ = 0;
  line_ += figures_.chains;
  if (all_marks_entered()) through.write(++frames_through_);
}

}  // namespace csgsim::scan_line
