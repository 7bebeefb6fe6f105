#include "hw/multi_processor/display_processor.h"

#include <utility>

#include "hw/division/division_check.h"
#include "hw/division/encoding.h"
#include "hw/multi_processor/model_host.h"
#include "hw/multi_processor/regions.h"
#include "hw/multi_processor/test_clocks.h"

namespace csgsim::multi_processor {

DisplayProcessor::DisplayProcessor(sc_core::sc_module_name name, const machines::Machine& machine)
    : sc_core::sc_module(name),
      time_(machine),
      figures_(machines::own<Figures>(machine)),
      nodes_(machine.array),
      bus_width_(machine.link.width) {
  SC_HAS_PROCESS(DisplayProcessor);
  SC_METHOD(on_host_word);
  dont_initialize();
  sensitive << host;
  SC_METHOD(on_bus_word);
  dont_initialize();
  sensitive << bus;
  SC_THREAD(work);
}

void DisplayProcessor::begin() {
  bits_taken_ = 0;
  model_bytes_ = 0;
  memory_.clear();
  divider_.reset();
  first_word_ = words_;
  segment_ = {};
  counted_ = {};
  stays_.begin(DisplayActivity::receiving, time_.now());
  start_.notify(sc_core::SC_ZERO_TIME);
}

FrameAccount DisplayProcessor::counted() const {
  FrameAccount counted = counted_;
  counted.broadcast_words = words_ - first_word_;
  counted.display = stays_.clocks(time_.now());
  return counted;
}

/// The length, then the bytes.
void DisplayProcessor::on_host_word() {
  constexpr unsigned byte_bits = 8;
  const isa::LinkWord& word = host.read().word;
  ++counted_.model_words;
  for (unsigned i = 0; i < figures_.host.width; ++i, ++bits_taken_) {
    if (bits_taken_ < length_bits) {
      model_bytes_ |= word.number(i, 1) << bits_taken_;
      continue;
    }
    const std::uint64_t place = bits_taken_ - length_bits;
    if (place >= byte_bits * model_bytes_) break;
    if (place % byte_bits == 0) memory_.push_back(0);
    memory_.back() = static_cast<std::uint8_t>(memory_.back() | word.number(i, 1) << place % byte_bits);
  }
  if (bits_taken_ >= length_bits + byte_bits * model_bytes_) model_received_.notify(sc_core::SC_ZERO_TIME);
}

void DisplayProcessor::work() {
  while (true) {
    wait(start_);
    draw();
    frames.write(++drawn_);
  }
}

void DisplayProcessor::draw() {
  receive_model();
  spend(DisplayActivity::transforming, model_.planes.size() * figures_.transform_clocks);
  broadcast_frame();
  for (const isa::Region& segment : picture_segments({model_.width, model_.height}, figures_.levels)) {
    draw_segment(segment);
  }
  wait_for_nodes();
}

void DisplayProcessor::receive_model() {
  const std::uint64_t begun = time_.now();
  wait(model_received_);
  model_ = division::display_model_of(memory_);
  divider_.emplace(model_);
  counted_.stages.reception = time_.now() - begun;
  stays_.change(DisplayActivity::waiting_for_nodes, time_.now());
}

void DisplayProcessor::spend(DisplayActivity activity, std::uint64_t clocks) {
  const std::uint64_t begun = time_.now();
  stays_.change(activity, begun);
  if (clocks > 0) wait(time_.of(clocks));
  stays_.change(DisplayActivity::waiting_for_nodes, time_.now());
  (activity == DisplayActivity::dividing ? counted_.stages.first_pruning : counted_.stages.transformation) +=
      time_.now() - begun;
}

void DisplayProcessor::draw_segment(const isa::Region& segment) {
  if (!figures_.divides_ahead) wait_for_nodes();
  const division::Candidates left = prune(segment);
  const std::size_t parts = parts_of(segment, nodes_.width, nodes_.height).size();
  // A picture that is one subsegment has a list whatever is left.
  const bool is_picture = parts == 1 && segment == isa::Region{0, 0, model_.width, model_.height};
  const bool is_active = !left.primitives.empty() || is_picture;
  wait_for_nodes();
  broadcast(segment, left, is_active);
  ++counted_.segment_count;
  if (is_active) ++counted_.active_segments;
  ++barriers_;
  lists_to_come_ = is_active ? parts : 0;
}

/// Nodes come to the barrier once for each message with a list, or a part of it.
void DisplayProcessor::on_bus_word() {
  const BusLines& lines = bus.read();
  if (lines.master == display_master) return;
  const bool is_command = lines.sent.kind == WordKind::command;
  is_list_ = is_list_ || is_command;
  if (!lines.sent.last) return;
  if (std::exchange(is_list_, false)) ++barriers_;
  if (is_command) --lists_to_come_;
}

division::Candidates DisplayProcessor::prune(const isa::Region& segment) {
  segment_ = segment;
  division::PlainDatapath path(model_);
  division::Candidates left = divider_->survivors(segment, path);
  const division::Counts counts = path.take_counts();
  counted_.first_box_tests += counts.boxes;
  counted_.first_halfspace_tests += counts.halfspaces;
  counted_.first_cell_tests += counts.cells;
  spend(DisplayActivity::dividing, clocks_of(counts, figures_.display_tests));
  return left;
}

void DisplayProcessor::broadcast_frame() {
  begin_broadcast();
  send(frame_records(model_), WordKind::frame, true);
  end_broadcast();
}

void DisplayProcessor::broadcast(const isa::Region& segment, const division::Candidates& left, bool is_active) {
  begin_broadcast();
  send(isa::SegmentStart{segment}, false);
  if (is_active) send(segment_records(model_, left), WordKind::segment, false);
  send(isa::SegmentEnd{}, true);
  end_broadcast();
  counted_.broadcast_primitives += left.primitives.size();
  counted_.broadcast_halfspaces += left.entries() - left.primitives.size();
}

void DisplayProcessor::begin_broadcast() { stays_.change(DisplayActivity::broadcasting, time_.now()); }

void DisplayProcessor::end_broadcast() {
  counted_.stages.broadcasting += stays_.since(time_.now());
  stays_.change(DisplayActivity::waiting_for_nodes, time_.now());
}

void DisplayProcessor::send(const isa::Command& command, bool last) {
  std::vector<isa::LinkWord> words;
  isa::encode(command, bus_width_, [&](const isa::LinkWord& word) { words.push_back(word); });
  for (std::size_t i = 0; i < words.size(); ++i) {
    send({.number = 0, .kind = WordKind::command, .last = last && i + 1 == words.size(), .word = words[i]});
  }
}

void DisplayProcessor::send(const Records& records, WordKind kind, bool last) {
  for (std::size_t record = 0; record < records.size(); ++record) {
    const std::vector<isa::LinkWord> words = division::to_link(records[record], bus_width_);
    for (std::size_t i = 0; i < words.size(); ++i) {
      const bool is_last = last && record + 1 == records.size() && i + 1 == words.size();
      send({.number = 0, .kind = kind, .last = is_last, .word = words[i]});
    }
  }
}

/// Returns when the word has gone.
void DisplayProcessor::send(const BusRequest& word) {
  BusRequest numbered = word;
  numbered.number = ++words_;
  request.write(numbered);
  do {
    wait(bus.value_changed_event());
  } while (bus.read().master != display_master || bus.read().sent.number != words_);
}

void DisplayProcessor::wait_for_nodes() {
  while (lists_to_come_ > 0 || released.read() < barriers_) wait(released.value_changed_event());
}

}  // namespace csgsim::multi_processor
