#include "hw/multi_processor/node.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "hw/multi_processor/list_renderer.h"

namespace csgsim::multi_processor {

Node::Node(sc_core::sc_module_name name, const machines::Machine& machine, std::uint32_t number)
    : sc_core::sc_module(name),
      time_(machine),
      figures_(machines::own<Figures>(machine)),
      nodes_(machine.array),
      number_(number),
      bus_width_(machine.link.width),
      bus_word_clocks_(machine.link.word_clocks),
      decoder_(machine.link.width) {
  SC_HAS_PROCESS(Node);
  SC_METHOD(on_word);
  dont_initialize();
  sensitive << bus;
  SC_THREAD(work);
}

void Node::begin(const isa::FrameHeader& frame) {
  frame_ = frame;
  const isa::Region picture{0, 0, frame.shape.width, frame.shape.height};
  image_columns_ = pixels_of(picture, nodes_, 0, 0).columns;
  const std::uint32_t image_rows = pixels_of(picture, nodes_, 0, 0).rows;
  image_.assign(std::size_t{image_columns_} * image_rows, 0);
  first_word_ = words_;
  box_tests_ = 0;
  halfspace_tests_ = 0;
  stays_.begin(NodeActivity::waiting, time_.now());
}

void Node::tell(FrameAccount& counted) const {
  counted.second_box_tests += box_tests_;
  counted.second_halfspace_tests += halfspace_tests_;
  counted.shared_words += words_ - first_word_;
  counted.nodes.push_back(account());
}

/// Every word takes the node the time that it is on the bus.
void Node::on_word() {
  const BusLines& lines = bus.read();
  if (lines.master == display_master && !receiving_) {
    receiving_ = true;
    primitive_words_ = 0;
    halfspace_words_ = 0;
    stays_.change(NodeActivity::receiving, time_.now() - bus_word_clocks_);
  }
  switch (lines.sent.kind) {
    case WordKind::primitive: ++primitive_words_; return;
    case WordKind::halfspace: ++halfspace_words_; return;
    case WordKind::command: break;
  }
  if (const std::optional<isa::Command> command = decoder_.take(lines.sent.word)) take(*command);
}

void Node::take(const isa::Command& command) {
  if (const auto* start = std::get_if<isa::SegmentStart>(&command)) {
    if (receiving_) {
      segment_ = start->region;
      lists_.clear();
      lists_received_ = 0;
    } else {
      lists_.push_back({start->region, {}});
    }
  } else if (const auto* instruction = std::get_if<isa::Instruction>(&command)) {
    lists_.back().instructions.push_back(*instruction);
  } else if (receiving_) {
    receiving_ = false;
    stays_.change(NodeActivity::waiting, time_.now());
    segment_received_.notify(sc_core::SC_ZERO_TIME);
  } else {
    ++lists_received_;
    list_received_.notify(sc_core::SC_ZERO_TIME);
  }
}

void Node::work() {
  while (true) {
    wait(segment_received_);
    if (primitive_words_ == 0) {
      clear_segment();
      continue;
    }
    const std::vector<isa::Region> parts = parts_of(segment_, nodes_.width, nodes_.height);
    prune(parts);
    share(parts);
    for (const List& list : lists_) render(list);
  }
}

void Node::spend(NodeActivity activity, std::uint64_t clocks) {
  stays_.change(activity, time_.now());
  if (clocks > 0) wait(time_.of(clocks));
  stays_.change(NodeActivity::waiting, time_.now());
}

void Node::wait_for_others() {
  arrival.write(++arrivals_);
  while (released.read() < arrivals_) wait(released.value_changed_event());
}

/// The primitives of the segment, and then the half-spaces of those that touch the node's own subsegment.
void Node::prune(const std::vector<isa::Region>& parts) {
  const auto words = [this](std::uint32_t bits) { return (bits + bus_width_ - 1) / bus_width_; };
  if (number_ < parts.size()) {
    const std::uint64_t primitives = primitive_words_ / words(figures_.primitive_bits);
    const std::uint64_t halfspaces =
        std::min(halfspace_words_ / words(figures_.halfspace_bits), division->subsegment(parts[number_]).halfspaces);
    box_tests_ += primitives;
    halfspace_tests_ += halfspaces;
    spend(NodeActivity::pruning,
          primitives * figures_.node_tests.primitive + halfspaces * figures_.node_tests.halfspace);
  }
  wait_for_others();
}

/// Node after node sends its list, which all take in.
void Node::share(const std::vector<isa::Region>& parts) {
  stays_.change(NodeActivity::sharing, time_.now());
  while (lists_received_ < parts.size()) {
    const std::size_t turn = lists_received_;
    if (turn == number_) send(parts[turn], division->subsegment(parts[turn]).list);
    while (lists_received_ == turn) wait(list_received_);
  }
  stays_.change(NodeActivity::waiting, time_.now());
}

void Node::send(const isa::Region& part, std::span<const isa::Instruction> list) {
  send(isa::SegmentStart{part}, false);
  for (const isa::Instruction& instruction : list) send(instruction, false);
  send(isa::SegmentEnd{}, true);
}

void Node::send(const isa::Command& command, bool last) {
  std::vector<isa::LinkWord> words;
  isa::encode(command, bus_width_, [&](const isa::LinkWord& word) { words.push_back(word); });
  for (std::size_t i = 0; i < words.size(); ++i) {
    request.write(
        {.number = ++words_, .kind = WordKind::command, .last = last && i + 1 == words.size(), .word = words[i]});
    do {
      wait(bus.value_changed_event());
    } while (bus.read().master != master_of(number_) || bus.read().sent.number != words_);
  }
}

void Node::render(const List& list) {
  std::vector<kernel::Keep> keeps;
  for (std::uint32_t index = 0; index < list.instructions.size(); ++index) {
    keeps.push_back(collector->keeps_after(list.region, index));
  }
  const NodePixels own = pixels_of(list.region, nodes_, number_ / nodes_.width, number_ % nodes_.width);
  if (list.instructions.empty()) {
    spend(NodeActivity::rendering, background_clocks(figures_, own, frame_.colour));
    store(list.region, own, std::vector<std::uint32_t>(own.count(), frame_.background));
    collector->after_subsegment(number_, list.region, {});
    return wait_for_others();
  }
  ListRenderer renderer(figures_, nodes_, list.instructions, keeps, own);
  renderer.render();
  const std::vector<std::uint32_t> colours = renderer.store_colours(frame_.colour);
  spend(NodeActivity::rendering, renderer.clocks());
  if (frame_.colour.width > 0) store(list.region, own, colours);
  for (NodeState& step : renderer.steps()) collector->after_instruction(number_, std::move(step));
  collector->after_subsegment(number_, list.region, {.pixels = std::move(renderer.memory())});
  wait_for_others();
}

/// Nothing touches it.
void Node::clear_segment() {
  const NodePixels own = pixels_of(segment_, nodes_, number_ / nodes_.width, number_ % nodes_.width);
  spend(NodeActivity::rendering, background_clocks(figures_, own, frame_.colour));
  store(segment_, own, std::vector<std::uint32_t>(own.count(), frame_.background));
  collector->after_clear(segment_);
  wait_for_others();
}

void Node::store(const isa::Region& region, const NodePixels& own, std::span<const std::uint32_t> colours) {
  for (std::uint32_t row = 0; row < own.rows; ++row) {
    const std::size_t y = (region.y + own.first_y) / nodes_.height + row;
    const std::size_t x = (region.x + own.first_x) / nodes_.width;
    std::copy_n(&colours[std::size_t{row} * own.columns], own.columns, &image_[y * image_columns_ + x]);
  }
}

}  // namespace csgsim::multi_processor
