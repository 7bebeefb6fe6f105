#include "hw/multi_processor/node.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "hw/multi_processor/list_renderer.h"
#include "hw/multi_processor/test_clocks.h"

namespace csgsim::multi_processor {

Node::Node(sc_core::sc_module_name name, const machines::Machine& machine, std::uint32_t number)
    : sc_core::sc_module(name),
      time_(machine),
      figures_(machines::own<Figures>(machine)),
      nodes_(machine.array),
      number_(number),
      bus_width_(machine.link.width),
      bus_word_clocks_(machine.link.word_clocks),
      decoder_(machine.link.width),
      records_(machine.link.width) {
  SC_HAS_PROCESS(Node);
  SC_METHOD(on_word);
  dont_initialize();
  sensitive << bus;
  SC_THREAD(work);
}

void Node::begin() {
  first_word_ = words_;
  tests_ = {};
  rendering_ = {};
  stays_.begin(NodeActivity::waiting, time_.now());
}

void Node::tell(FrameAccount& counted) const {
  counted.second_box_tests += tests_.boxes;
  counted.second_halfspace_tests += tests_.halfspaces;
  counted.second_cell_tests += tests_.cells;
  counted.second_tree_nodes += tests_.nodes;
  counted.shared_words += words_ - first_word_;
  counted.nodes.push_back(account());
}

/// Every word takes the node the time that it is on the bus.
void Node::on_word() {
  const BusLines& lines = bus.read();
  if (lines.master == display_master && !receiving_) begin_receiving();
  if (lines.sent.kind != WordKind::command) return take_record(lines.sent);
  if (const std::optional<isa::Command> command = decoder_.take(lines.sent.word)) take(*command);
}

void Node::begin_receiving() {
  receiving_ = true;
  is_active_ = false;
  if (bus.read().sent.kind == WordKind::frame) records_.begin_frame();
  stays_.change(NodeActivity::receiving, time_.now() - bus_word_clocks_);
}

void Node::take_record(const BusRequest& sent) {
  if (sent.kind == WordKind::segment && !std::exchange(is_active_, true)) records_.begin_segment();
  records_.take(sent.word);
  if (sent.kind == WordKind::frame && sent.last) begin_frame();
}

void Node::begin_frame() {
  receiving_ = false;
  stays_.change(NodeActivity::waiting, time_.now());
  const NodePixels most = pixels_of({0, 0, records_.model().width, records_.model().height}, nodes_, 0, 0);
  image_columns_ = most.columns;
  image_.assign(std::size_t{most.columns} * most.rows, 0);
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
    if (!is_active_) {
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

/// Makes the list of the node's own subsegment of what has come.
void Node::prune(const std::vector<isa::Region>& parts) {
  if (number_ < parts.size()) {
    division::PlainDatapath path(records_.model());
    divided_ = division::Divider(records_.model()).divide(parts[number_], records_.left(), path);
    const division::Counts counts = divided_.counts();
    tests_ += counts;
    spend(NodeActivity::pruning, clocks_of(counts, figures_.node_tests));
  }
  wait_for_others();
}

/// Node after node sends its list, which all take in.
void Node::share(const std::vector<isa::Region>& parts) {
  stays_.change(NodeActivity::sharing, time_.now());
  while (lists_received_ < parts.size()) {
    const std::size_t turn = lists_received_;
    if (turn == number_) send_list(parts[turn]);
    while (lists_received_ == turn) wait(list_received_);
  }
  stays_.change(NodeActivity::waiting, time_.now());
}

void Node::send_list(const isa::Region& part) {
  send(isa::SegmentStart{part}, false);
  for (const isa::Instruction& instruction : divided_.instructions) send(instruction, false);
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
  if (list.instructions.empty()) {
    clear(list.region);
    collector->after_subsegment(number_, list.region, {});
    return wait_for_others();
  }
  std::vector<systemc::Keep> keeps;
  for (std::uint32_t index = 0; index < list.instructions.size(); ++index) {
    keeps.push_back(collector->keeps_after(list.region, index));
  }
  const NodePixels own = own_pixels(list.region);
  ListRenderer renderer(figures_, nodes_, list.instructions, keeps, own);
  renderer.render();
  const std::vector<std::uint32_t> colours = renderer.store_colours(records_.model().fields.colour);
  rendering_ = {&list, time_.now()};
  spend(NodeActivity::rendering, renderer.clocks());
  rendering_ = {};
  store(list.region, own, colours);
  for (NodeState& step : renderer.steps()) collector->after_instruction(number_, std::move(step));
  collector->after_subsegment(number_, list.region, {.pixels = std::move(renderer.memory())});
  wait_for_others();
}

NodePixels Node::own_pixels(const isa::Region& region) const {
  return pixels_of(region, nodes_, number_ / nodes_.width, number_ % nodes_.width);
}

void Node::clear(const isa::Region& region) {
  const NodePixels own = own_pixels(region);
  const division::DisplayModel& model = records_.model();
  spend(NodeActivity::rendering, background_clocks(figures_, own, model.fields.colour));
  store(region, own, std::vector<std::uint32_t>(own.count(), model.background));
}

/// Nothing touches it.
void Node::clear_segment() {
  clear(segment_);
  collector->after_clear(segment_);
  wait_for_others();
}

void Node::store(const isa::Region& region, const NodePixels& own, const std::vector<std::uint32_t>& colours) {
  for (std::uint32_t row = 0; row < own.rows; ++row) {
    const std::size_t y = (region.y + own.first_y) / nodes_.height + row;
    const std::size_t x = (region.x + own.first_x) / nodes_.width;
    std::copy_n(&colours[std::size_t{row} * own.columns], own.columns, &image_[y * image_columns_ + x]);
  }
}

}  // namespace csgsim::multi_processor
