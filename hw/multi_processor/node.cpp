#include "hw/multi_processor/node.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <utility>
#include <variant>

#include "hw/base/quotient.h"
#include "hw/isa/link_word.h"
#include "hw/multi_processor/list_renderer.h"

namespace csgsim::multi_processor {

Node::Node(sc_core::sc_module_name name, const machines::Machine& machine, std::uint32_t number)
    : sc_core::sc_module(name),
      time_(machine),
      figures_(machines::kind_figures<Figures>(machine)),
      nodes_(machine.array),
      number_(number),
      bus_width_(machine.link.width),
      bus_word_clocks_(machine.link.word_clocks),
      bus_latency_(machine.link.latency),
      decoder_(machine.link.width),
      entries_(machine.link.width),
      records_(machine.link.width, figures_.word_bits),
      own_(figures_),
      screen_(figures_.refresh, machine.clock_hz) {
  SC_HAS_PROCESS(Node);
  SC_METHOD(on_word);
  dont_initialize();
  sensitive << bus;
  SC_THREAD(work);
}

void Node::begin() {
  first_word_ = words_;
  tests_ = {};
  passes_ = turn_dividing_clocks_ = 0;
  rendering_ = {};
  frame_start_ = time_.now();
  activities_.begin(NodeActivity::waiting, time_.now());
}

void Node::add_counts(FrameAccount& frame_counts) const {
  frame_counts.second_box_tests += tests_.boxes;
  frame_counts.second_halfspace_tests += tests_.halfspaces;
  frame_counts.second_cell_tests += tests_.cells;
  frame_counts.second_tree_nodes += tests_.nodes;
  frame_counts.shared_words += words_ - first_word_;
  frame_counts.nodes.push_back(account());
  // StageWatch counts these clocks as sharing, since it sees only an idle bus.
  frame_counts.stages.second_pruning += turn_dividing_clocks_;
  frame_counts.stages.sharing -= turn_dividing_clocks_;
  if (number_ == 0) frame_counts.list_passes = passes_;
}

/// Receiving a word occupies the node for the time that the word is on the bus.
void Node::on_word() {
  const BusLines& lines = bus.read();
  if (lines.master == display_master) return take_from_display(lines.sent);
  take_from_node(lines.sent);
}

void Node::take_from_display(const BusRequest& bus_word) {
  if (bus_word.kind == WordKind::answer) return take_answer(bus_word);
  if (!receiving_) begin_receiving();
  if (bus_word.kind != WordKind::command) return take_record(bus_word);
  const std::optional<isa::Command> command = decoder_.take(bus_word.word);
  if (!command) return;
  if (const auto* start = std::get_if<isa::SegmentStart>(&*command)) return begin_segment(start->region);
  receiving_ = false;
  form_ = choose_list_form();
  activities_.change(NodeActivity::waiting, time_.now());
  segment_received_.notify(sc_core::SC_ZERO_TIME);
}

void Node::begin_segment(const isa::Region& segment) {
  segment_ = segment;
  parts_ = divide_region(segment, nodes_.width, nodes_.height);
  lists_received_ = 0;
}

void Node::take_from_node(const BusRequest& bus_word) {
  if (bus_word.kind == WordKind::request) return;
  if (!sharing_) begin_sharing(time_.now() - bus_word_clocks_ - bus_latency_);
  if (bus_word.kind == WordKind::command) {
    if (const auto command = entries_.take(bus_word.word, form_, records_.model())) take_list_command(*command);
  }
  if (!bus_word.last) return;
  paused_ = bus_word.kind == WordKind::pause || is_remote_;
  if (paused_ || lists_received_ == parts_.size()) {
    sharing_ = false;
    activities_.change(NodeActivity::waiting, time_.now());
  }
  message_ended_.notify(sc_core::SC_ZERO_TIME);
}

void Node::begin_sharing(std::uint64_t clock) {
  sharing_ = true;
  activities_.change(NodeActivity::sharing, clock);
}

/// A message contains commands of one list.
void Node::take_list_command(const isa::Command& command) {
  if (const auto* start = std::get_if<isa::SegmentStart>(&command))
    open_ = {.region = start->region, .first = 0, .instructions = {}, .ends = false, .form = form_};
  if (lists_.empty() || lists_.back().ends) lists_.push_back(open_);
  List& list = lists_.back();
  if (const auto* instruction = std::get_if<isa::Instruction>(&command)) list.instructions.push_back(*instruction);
  if (std::holds_alternative<isa::SegmentEnd>(command)) {
    list.ends = true;
    ++lists_received_;
  }
  open_.first = list.first + list.instructions.size();
  list_words_ += quotient_up(entry_bits(command, form_), std::uint64_t{figures_.word_bits});
  if (bus.read().master == master_of(number_)) own_.send();
  update_room_line();
}

/// A sending node always has room, because its memory already holds the commands that it sends.
void Node::update_room_line() {
  const std::uint32_t max_words = quotient_up(std::uint32_t{isa::LinkWord::max_bits}, figures_.word_bits);
  room->set_pulled(number_, !sending_ && room_for_lists() - own_.words() - list_words_ < max_words);
}

/// Half-spaces are numbered in the order of their arrival.
ListForm Node::choose_list_form() const {
  if (figures_.lists == ListKind::instructions || !is_active_ || is_remote_) return {};
  const std::size_t planes = records_.model().planes.size();
  const auto bits = static_cast<unsigned>(std::bit_width(planes > 0 ? planes - 1 : 0));
  ListForm form{
      .has_numbers = true, .number_bits = std::max(bits, 1U), .record_bits = records_.format().halfspace_record()};
  const std::array<unsigned, 5> numbers = records_.format().halfspace_numbers();
  std::transform(numbers.begin(), numbers.end(), form.record_numbers.begin(),
                 [](unsigned width) { return static_cast<std::uint8_t>(width); });
  return form;
}

std::uint64_t Node::room_for_lists() const { return figures_.memory_words - records_.memory_words(); }

void Node::begin_receiving() {
  receiving_ = true;
  is_active_ = false;
  if (bus.read().sent.kind == WordKind::frame) records_.begin_frame();
  activities_.change(NodeActivity::receiving, time_.now() - bus_word_clocks_);
}

void Node::take_record(const BusRequest& bus_word) {
  if (is_segment_record(bus_word.kind) && !std::exchange(is_active_, true)) {
    is_remote_ = bus_word.kind == WordKind::heads;
    records_.begin_segment(!is_remote_);
  }
  records_.take(bus_word.word);
  if (bus_word.kind == WordKind::frame && bus_word.last) begin_frame();
}

void Node::begin_frame() {
  receiving_ = false;
  activities_.change(NodeActivity::waiting, time_.now());
  const NodePixels most_pixels = pixels_of_node({0, 0, records_.model().width, records_.model().height}, nodes_, 0, 0);
  image_columns_ = most_pixels.columns;
  screen_.begin(frame_start_, most_pixels.count(), records_.model().fields.colour.width);
  image_.assign(std::size_t{most_pixels.columns} * most_pixels.rows, 0);
}

void Node::work() {
  while (true) {
    wait(segment_received_);
    if (!is_active_) {
      clear_segment();
      continue;
    }
    prune();
    draw_lists();
  }
}

void Node::spend(NodeActivity activity, std::uint64_t clocks) {
  activities_.change(activity, time_.now());
  advance(clocks);
  activities_.change(NodeActivity::waiting, time_.now());
}

/// Spends the clocks, stalling during turns of the screen.
void Node::advance(std::uint64_t clocks) {
  work_done_ = 0;
  while (work_done_ < clocks) {
    const std::uint64_t now = time_.now();
    const std::uint64_t free = screen_.free_clocks_from(now, clocks - work_done_);
    if (free == 0) {
      wait(time_.of(screen_.turn_clocks_left(now)));
      continue;
    }
    working_since_ = now;
    is_working_ = true;
    wait(time_.of(free));
    is_working_ = false;
    work_done_ += free;
  }
}

void Node::wait_for_others() {
  arrival.write(++arrivals_);
  while (released.read() < arrivals_) wait(released.value_changed_event());
}

/// Builds the part of the node's own list that fits half of the free memory; the other half is reserved for the lists
/// of other nodes.
void Node::prune() {
  own_.clear();
  if (number_ < parts_.size() && !is_remote_) {
    own_.begin(parts_[number_], records_, form_, parts_.size() == 1 ? room_for_lists() : room_for_lists() / 2);
    tests_ += own_.counts();
    spend(NodeActivity::pruning, own_.build());
  }
  update_room_line();
  wait_for_others();
}

/// The nodes send their lists in turn to all nodes; all nodes render what they have received at each pause and at the
/// end.
void Node::draw_lists() {
  if (!is_remote_) begin_sharing(time_.now());
  while (lists_received_ < parts_.size()) {
    const bool is_own_turn = lists_received_ == number_;
    if (is_own_turn && is_remote_) {
      divide_remotely();
      continue;
    }
    if (is_own_turn) send_list();
    wait(message_ended_);
    if (paused_) render_lists();
  }
  if (!lists_.empty()) render_lists();
}

/// Sends commands that the node has built, as long as the other nodes have room for them.
void Node::send_list() {
  if (!own_.has_unsent()) {
    dividing_since_ = time_.now();
    spend(NodeActivity::pruning, own_.build());
    turn_dividing_clocks_ += time_.now() - dividing_since_;
  }
  if (!sharing_) begin_sharing(time_.now());
  sending_ = true;
  update_room_line();
  bool ends = false;
  while (!ends && own_.has_unsent() && !room->is_pulled()) {
    const isa::Command next = own_.next();
    ends = std::holds_alternative<isa::SegmentEnd>(next);
    send(next, ends);
    if (!ends) wait(sc_core::SC_ZERO_TIME);  // waits until all nodes have received the command
  }
  if (!ends) send_word(WordKind::pause, {}, true);
  sending_ = false;
  update_room_line();
}

void Node::send(const isa::Command& command, bool is_last) {
  const std::vector<isa::LinkWord> words = entry_words(command, form_, records_.model(), parts_[number_], bus_width_);
  for (std::size_t i = 0; i < words.size(); ++i)
    send_word(WordKind::command, words[i], is_last && i + 1 == words.size());
}

/// Returns when the word has been transferred.
void Node::send_word(WordKind kind, const isa::LinkWord& word, bool is_last) {
  request.write({.number = ++words_, .kind = kind, .last = is_last, .word = word});
  do {
    wait(bus.value_changed_event());
  } while (bus.read().master != master_of(number_) || bus.read().sent.number != words_);
}

void Node::render_lists() {
  ++passes_;
  list_words_ = 0;
  update_room_line();
  for (const List& list : lists_) render(list);
  lists_.clear();
}

void Node::render(const List& list) {
  const NodePixels own = own_pixels(list.region);
  if (list.begins() && list.instructions.empty()) {
    if (list.ends) {
      clear(list.region);
      collector->after_subsegment(number_, list.region, {});
    }
    return wait_for_others();
  }
  std::vector<systemc::Keep> keeps;
  for (std::size_t i = 0; i < list.instructions.size(); ++i) {
    keeps.push_back(collector->required_after(list.region, static_cast<std::uint32_t>(list.first + i)));
  }
  const PixelMemory before = std::exchange(saved_, {}).pixels;
  ListRenderer renderer(figures_, nodes_, list.instructions, list.form, keeps, own, before);
  renderer.render();
  std::vector<std::uint32_t> colours;
  if (list.ends) colours = renderer.store_colours(records_.model().fields.colour);
  rendering_ = {&list, time_.now(), &before};
  spend(NodeActivity::rendering, renderer.clocks());
  rendering_ = {};
  for (NodeState& step : renderer.steps()) collector->after_instruction(number_, std::move(step));
  if (list.ends) {
    store_image(list.region, own, colours);
    collector->after_subsegment(number_, list.region, {.pixels = std::move(renderer.memory())});
  } else {
    saved_ = {list.region, std::move(renderer.memory())};
  }
  wait_for_others();
}

NodePixels Node::own_pixels(const isa::Region& region) const {
  return pixels_of_node(region, nodes_, number_ / nodes_.width, number_ % nodes_.width);
}

void Node::clear(const isa::Region& region) {
  const NodePixels own = own_pixels(region);
  const division::DisplayModel& model = records_.model();
  spend(NodeActivity::rendering, background_clocks(figures_, own, model.fields.colour));
  store_image(region, own, std::vector<std::uint32_t>(own.count(), model.background));
}

/// Clears a segment that no primitive touches.
void Node::clear_segment() {
  clear(segment_);
  collector->after_clear(segment_);
  wait_for_others();
}

void Node::store_image(const isa::Region& region, const NodePixels& node_pixels,
                       const std::vector<std::uint32_t>& colours) {
  for (std::uint32_t row = 0; row < node_pixels.rows; ++row) {
    const std::size_t y = (region.y + node_pixels.first_y) / nodes_.height + row;
    const std::size_t x = (region.x + node_pixels.first_x) / nodes_.width;
    std::copy_n(&colours[std::size_t{row} * node_pixels.columns], node_pixels.columns, &image_[y * image_columns_ + x]);
  }
}

}  // namespace csgsim::multi_processor
