#include "hw/multi_processor/display_processor.h"

#include "hw/multi_processor/regions.h"

namespace csgsim::multi_processor {

DisplayProcessor::DisplayProcessor(sc_core::sc_module_name name, const machines::Machine& machine)
    : sc_core::sc_module(name),
      time_(machine),
      figures_(machines::own<Figures>(machine)),
      nodes_(machine.array),
      bus_width_(machine.link.width) {
  SC_HAS_PROCESS(DisplayProcessor);
  SC_THREAD(work);
}

void DisplayProcessor::begin(const std::vector<isa::Region>& segments, const isa::ModelFacts& model) {
  segments_ = segments;
  primitives_ = model.primitives;
  halfspaces_ = model.halfspaces;
  first_word_ = words_;
  active_segments_ = 0;
  box_tests_ = 0;
  halfspace_tests_ = 0;
  sent_primitives_ = 0;
  sent_halfspaces_ = 0;
  stages_ = {};
  stays_.begin(DisplayActivity::waiting_for_nodes, time_.now());
  start_.notify(sc_core::SC_ZERO_TIME);
}

void DisplayProcessor::tell(FrameAccount& counted) const {
  counted.segments = segments_.size();
  counted.active_segments = active_segments_;
  counted.first_box_tests = box_tests_;
  counted.first_halfspace_tests = halfspace_tests_;
  counted.broadcast_primitives = sent_primitives_;
  counted.broadcast_halfspaces = sent_halfspaces_;
  counted.broadcast_words = words_ - first_word_;
  counted.stages.transformation = stages_.transformation;
  counted.stages.first_pruning = stages_.first_pruning;
  counted.stages.broadcasting = stages_.broadcasting;
  counted.display = account();
}

void DisplayProcessor::work() {
  while (true) {
    wait(start_);
    draw();
    frames.write(++drawn_);
  }
}

void DisplayProcessor::draw() {
  spend(DisplayActivity::transforming, halfspaces_ * figures_.transform_clocks);
  for (const isa::Region& segment : segments_) {
    const std::vector<isa::Region> parts = parts_of(segment, nodes_.width, nodes_.height);
    if (!figures_.divides_ahead) wait_for_nodes();
    const DividedSegment divided = divide(parts);
    wait_for_nodes();
    broadcast(segment, divided);
    barriers_ += divided.primitives > 0 ? 1 + parts.size() : 1;
  }
  wait_for_nodes();
}

void DisplayProcessor::spend(DisplayActivity activity, std::uint64_t clocks) {
  const std::uint64_t begun = time_.now();
  stays_.change(activity, begun);
  if (clocks > 0) wait(time_.of(clocks));
  stays_.change(DisplayActivity::waiting_for_nodes, time_.now());
  (activity == DisplayActivity::dividing ? stages_.first_pruning : stages_.transformation) += time_.now() - begun;
}

DividedSegment DisplayProcessor::divide(const std::vector<isa::Region>& parts) {
  const DividedSegment divided = division->segment(parts);
  box_tests_ += primitives_;
  halfspace_tests_ += divided.halfspace_tests;
  if (divided.primitives > 0) ++active_segments_;
  spend(DisplayActivity::dividing,
        primitives_ * figures_.display_tests.primitive + divided.halfspace_tests * figures_.display_tests.halfspace);
  return divided;
}

void DisplayProcessor::broadcast(const isa::Region& segment, const DividedSegment& divided) {
  const auto words = [this](std::uint32_t bits) { return (bits + bus_width_ - 1) / bus_width_; };
  const std::uint64_t begun = time_.now();
  stays_.change(DisplayActivity::broadcasting, begun);
  send(isa::SegmentStart{segment}, false);
  send_data(WordKind::primitive, divided.primitives * words(figures_.primitive_bits));
  send_data(WordKind::halfspace, divided.halfspaces * words(figures_.halfspace_bits));
  send(isa::SegmentEnd{}, true);
  sent_primitives_ += divided.primitives;
  sent_halfspaces_ += divided.halfspaces;
  stages_.broadcasting += time_.now() - begun;
  stays_.change(DisplayActivity::waiting_for_nodes, time_.now());
}

void DisplayProcessor::send(const isa::Command& command, bool last) {
  std::vector<isa::LinkWord> words;
  isa::encode(command, bus_width_, [&](const isa::LinkWord& word) { words.push_back(word); });
  for (std::size_t i = 0; i < words.size(); ++i) {
    send({.number = 0, .kind = WordKind::command, .last = last && i + 1 == words.size(), .word = words[i]});
  }
}

void DisplayProcessor::send_data(WordKind kind, std::uint64_t words) {
  for (std::uint64_t i = 0; i < words; ++i) send({.number = 0, .kind = kind, .last = false, .word = {}});
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
  while (released.read() < barriers_) wait(released.value_changed_event());
}

}  // namespace csgsim::multi_processor
