#include "hw/scan_line/packet_queue.h"

#include <algorithm>

#include "hw/machines/clocks.h"
#include "hw/machines/timing.h"

namespace csgsim::scan_line {

PacketQueue::PacketQueue(sc_core::sc_module_name name, const machines::Machine& machine, std::uint32_t chain)
    : sc_core::sc_module(name), machine_(machine), chain_(chain) {
  SC_HAS_PROCESS(PacketQueue);
  SC_METHOD(on_clock);
  dont_initialize();
  sensitive << clock.pos();
}

void PacketQueue::begin(const Frame& frame) {
  frame_ = frame;
  budget_ = machines::line_budget(machine_, static_cast<std::uint32_t>(frame.lines.size()));
  line_ = chain_;
  index_ = 0;
  word_clocks_ = 0;
  packet_clocks_ = 0;
  line_clocks_ = 0;
  since_mark_ = machines::mark_spacing(frame.pixels());
  counts_ = {};
  if (line_ < frame_.lines.size()) next_packet();
}

void PacketQueue::on_clock() {
  const bool sends = line_ < frame_.lines.size();
  busy.write(sends);
  entry.write({});
  ++since_mark_;
  if (!sends) return;
  if (word_clocks_ < machine_.scan_line.packet_interval) {
    ++word_clocks_;
    ++packet_clocks_;
    ++line_clocks_;
    ++counts_.clocks;
  } else {
    ++counts_.waits;
  }
  if (word_clocks_ < machine_.scan_line.packet_interval || !may_enter()) return;
  entry.write(word_);
  word_clocks_ = 0;
  word_.last ? end_packet() : next_word();
}

void PacketQueue::next_packet() {
  const isa::Segment& line = frame_.lines[line_];
  word_ = {};
  if (index_ == line.instructions.size()) {
    words_ = 1;
    word_ = {.kind = WordKind::mark, .last = true, .keep = Keep::all};
    word_.instruction.fields[0] = frame_.colour;
    word_.instruction.constant = frame_.background;
  } else {
    const isa::Instruction& instruction = line.instructions[index_];
    words_ = static_cast<std::uint16_t>(machines::packet_words(instruction, machine_));
    word_ = packet_word(instruction, 0, machine_.scan_line.word_bits);
    word_.keep = frame_.listener->keeps_after(static_cast<std::uint32_t>(line_), index_);
    word_.last = words_ == 1;
  }
  word_.begins_line = index_ == 0;
  word_.segment = static_cast<std::uint32_t>(line_);
  word_.index = index_;
}

void PacketQueue::next_word() {
  const auto number = static_cast<std::uint16_t>(word_.number + 1);
  const PacketWord next = packet_word(word_.instruction, number, machine_.scan_line.word_bits);
  word_.number = number;
  word_.a = next.a;
  word_.f = next.f;
  word_.last = number + 1 == words_;
}

bool PacketQueue::may_enter() const {
  return word_.kind != WordKind::mark || since_mark_ >= machines::mark_spacing(frame_.pixels());
}

void PacketQueue::end_packet() {
  accounts.nb_write({.clocks = packet_clocks_});
  packet_clocks_ = 0;
  if (word_.kind == WordKind::mark) {
    end_line();
  } else {
    ++index_;
    ++counts_.packets;
  }
  if (line_ < frame_.lines.size()) next_packet();
}

void PacketQueue::end_line() {
  counts_.most_packets = std::max<std::uint64_t>(counts_.most_packets, index_);
  if (line_clocks_ > budget_) ++counts_.late_lines;
  line_clocks_ = 0;
  since_mark_ = 0;
  index_ = 0;
  line_ += machine_.scan_line.chains;
}

}  // namespace csgsim::scan_line
