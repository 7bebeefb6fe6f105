#include "hw/multi_processor/display_processor.h"

#include <utility>

#include "hw/base/quotient.h"
#include "hw/division/division_check.h"
#include "hw/division/encoding.h"
#include "hw/multi_processor/model_host.h"
#include "hw/multi_processor/regions.h"
#include "hw/multi_processor/test_clocks.h"

namespace csgsim::multi_processor {

DisplayProcessor::DisplayProcessor(sc_core::sc_module_name name, const machines::Machine& machine)
    : sc_core::sc_module(name),
      time_(machine),
      figures_(machines::kind_figures<Figures>(machine)),
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
  activities_.begin(DisplayActivity::receiving, time_.now());
  start_.notify(sc_core::SC_ZERO_TIME);
}

FrameAccount DisplayProcessor::frame_counts() const {
  FrameAccount counted = counted_;
  counted.broadcast_words = words_ - first_word_;
  counted.display = activities_.clocks(time_.now());
  return counted;
}

/// Receives the length of the model, then its bytes.
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
  if (has_planes_) spend(DisplayActivity::transforming, model_.planes.size() * figures_.transform_clocks);
  broadcast_frame();
  is_remote_ = false;
  for (const isa::Region& segment : picture_segments({model_.width, model_.height}, figures_.levels)) {
    draw_segment(segment);
  }
  wait_for_nodes();
}

void DisplayProcessor::receive_model() {
  const std::uint64_t start_clock = time_.now();
  wait(model_received_);
  model_ = division::display_model_of(memory_);
  divider_.emplace(model_);
  const std::uint64_t bits = length_bits + 8 * std::uint64_t{model_bytes_};
  const std::uint64_t plane_bits = model_.planes.size() * std::uint64_t{division::widths_of(model_).plane_record()};
  has_planes_ = quotient_up(bits, figures_.word_bits) <= figures_.display_memory_words;
  model_words_ = quotient_up(has_planes_ ? bits : bits - plane_bits, figures_.word_bits);
  counted_.stages.reception = time_.now() - start_clock;
  activities_.change(DisplayActivity::waiting_for_nodes, time_.now());
}

void DisplayProcessor::spend(DisplayActivity activity, std::uint64_t clocks) {
  const std::uint64_t start_clock = time_.now();
  activities_.change(activity, start_clock);
  if (clocks > 0) wait(time_.of(clocks));
  activities_.change(DisplayActivity::waiting_for_nodes, time_.now());
  (activity == DisplayActivity::dividing ? counted_.stages.first_pruning : counted_.stages.transformation) +=
      time_.now() - start_clock;
}

void DisplayProcessor::draw_segment(const isa::Region& segment) {
  if (!figures_.divides_ahead || is_remote_) wait_for_nodes();
  division::Candidates survivors = prune(segment);
  const std::size_t parts = divide_region(segment, nodes_.width, nodes_.height).size();
  // A picture that is one subsegment has a list even if no primitive is left.
  const bool is_picture = parts == 1 && segment == isa::Region{0, 0, model_.width, model_.height};
  const bool is_active = !survivors.primitives.empty() || is_picture;
  wait_for_nodes();
  survivors_ = std::move(survivors);
  is_remote_ = false;
  broadcast_segment(segment, is_active);
  ++counted_.segment_count;
  if (is_active) ++counted_.active_segments;
  ++barriers_;
  lists_to_come_ = is_active ? parts : 0;
}

/// Nodes reach the barrier once for each message with a list or a part of one.
void DisplayProcessor::on_bus_word() {
  const BusLines& lines = bus.read();
  if (lines.master == display_master) return;
  if (lines.sent.kind == WordKind::request) return take_request(lines.sent);
  const bool is_command = lines.sent.kind == WordKind::command;
  is_list_ = is_list_ || is_command;
  if (!lines.sent.last) return;
  if (std::exchange(is_list_, false)) ++barriers_;
  if (is_command) --lists_to_come_;
}

void DisplayProcessor::take_request(const BusRequest& bus_word) {
  append_word(request_, bus_word.word, bus_width_);
  if (!bus_word.last) return;
  request_pending_ = true;
  request_received_.notify(sc_core::SC_ZERO_TIME);
}

/// Returns the survivors. The tests are counted twice if memory cannot hold the survivors until they are sent.
division::Candidates DisplayProcessor::prune(const isa::Region& segment) {
  segment_ = segment;
  division::PlainDatapath path(model_);
  division::Candidates survivors = divider_->survivors(segment, path);
  const bool fits = model_words_ + memory_words(segment_records(model_, survivors)) <= figures_.display_memory_words;
  if (!fits) survivors = divider_->survivors(segment, path);
  const division::Counts counts = path.take_counts();
  counted_.first_box_tests += counts.boxes;
  counted_.first_halfspace_tests += counts.halfspaces;
  counted_.first_cell_tests += counts.cells;
  const std::uint64_t planes = has_planes_ ? 0 : counts.halfspaces * remote_plane_clocks();
  spend(DisplayActivity::dividing, clocks_of(counts, figures_.display_tests) + planes);
  return survivors;
}

/// Clocks to read a plane over the host's link and to transform it.
std::uint64_t DisplayProcessor::remote_plane_clocks() const {
  const unsigned bits = division::widths_of(model_).plane_record();
  return figures_.host.latency + std::uint64_t{quotient_up(bits, figures_.host.width)} * figures_.host.word_clocks +
         figures_.transform_clocks;
}

std::uint64_t DisplayProcessor::memory_words(const Records& records) const {
  std::uint64_t words = 0;
  for (const division::Bits& record : records) words += quotient_up(record.count, figures_.word_bits);
  return words;
}

void DisplayProcessor::broadcast_frame() {
  begin_broadcast();
  const Records records = frame_records(model_);
  frame_words_ = memory_words(records);
  send(records, WordKind::frame, true);
  end_broadcast();
}

/// Half-spaces stay here if they leave no room for two commands in a node.
void DisplayProcessor::broadcast_segment(const isa::Region& segment, bool is_active) {
  begin_broadcast();
  send(isa::SegmentStart{segment}, false);
  if (is_active) {
    const Records records = segment_records(model_, survivors_);
    const std::uint64_t reserved = 2 * quotient_up(std::uint64_t{isa::LinkWord::max_bits}, figures_.word_bits);
    is_remote_ = frame_words_ + memory_words(records) + reserved > figures_.memory_words;
    if (is_remote_) {
      send(segment_records_without_halfspaces(model_, survivors_), WordKind::heads, false);
    } else {
      send(records, WordKind::segment, false);
      counted_.broadcast_halfspaces += survivors_.entry_count() - survivors_.primitives.size();
    }
  }
  send(isa::SegmentEnd{}, true);
  end_broadcast();
  counted_.broadcast_primitives += survivors_.primitives.size();
}

void DisplayProcessor::answer_request() {
  request_pending_ = false;
  const HalfspaceId id = decode_request(model_, survivors_, std::exchange(request_, {}).take());
  activities_.change(DisplayActivity::broadcasting, time_.now());
  send({halfspace_record(model_, survivors_, id)}, WordKind::answer, true);
  activities_.change(DisplayActivity::waiting_for_nodes, time_.now());
  ++counted_.broadcast_halfspaces;
}

void DisplayProcessor::begin_broadcast() { activities_.change(DisplayActivity::broadcasting, time_.now()); }

void DisplayProcessor::end_broadcast() {
  counted_.stages.broadcasting += activities_.since(time_.now());
  activities_.change(DisplayActivity::waiting_for_nodes, time_.now());
}

void DisplayProcessor::send(const isa::Command& command, bool is_last) {
  std::vector<isa::LinkWord> words;
  isa::encode(command, bus_width_, [&](const isa::LinkWord& word) { words.push_back(word); });
  for (std::size_t i = 0; i < words.size(); ++i) {
    send({.number = 0, .kind = WordKind::command, .last = is_last && i + 1 == words.size(), .word = words[i]});
  }
}

void DisplayProcessor::send(const Records& records, WordKind kind, bool is_last) {
  for (std::size_t record = 0; record < records.size(); ++record) {
    const std::vector<isa::LinkWord> words = division::to_link(records[record], bus_width_);
    for (std::size_t i = 0; i < words.size(); ++i) {
      const bool is_last_word = is_last && record + 1 == records.size() && i + 1 == words.size();
      send({.number = 0, .kind = kind, .last = is_last_word, .word = words[i]});
    }
  }
}

/// Returns when the word has been transferred.
void DisplayProcessor::send(const BusRequest& word) {
  BusRequest numbered = word;
  numbered.number = ++words_;
  request.write(numbered);
  do {
    wait(bus.value_changed_event());
  } while (bus.read().master != display_master || bus.read().sent.number != words_);
}

void DisplayProcessor::wait_for_nodes() {
  while (lists_to_come_ > 0 || released.read() < barriers_) {
    if (request_pending_) {
      answer_request();
    } else {
      wait(released.value_changed_event() | request_received_);
    }
  }
}

}  // namespace csgsim::multi_processor
