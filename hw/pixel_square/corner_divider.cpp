#include "hw/pixel_square/corner_divider.h"

#include <algorithm>
#include <utility>

#include "hw/division/encoding.h"
#include "hw/pixel_square/storage_check.h"
#include "hw/systemc/kernel.h"

namespace csgsim::pixel_square {

using Level = SteppedDatapath::Level;

CornerDivider::CornerDivider(sc_core::sc_module_name name, const machines::Machine& machine,
                             const ModelReceiver& receiver)
    : sc_core::sc_module(name),
      machine_(machine),
      figures_(machines::kind_figures<Figures>(machine_)),
      period_(systemc::period_of(machine)),
      receiver_(receiver),
      store_(machine) {
  SC_HAS_PROCESS(CornerDivider);
  SC_THREAD(work);
}

void CornerDivider::begin(const machines::Size& picture, std::span<const isa::Region> squares,
                          std::vector<std::size_t> assigned) {
  picture_ = picture;
  squares_ = squares;
  assigned_ = std::move(assigned);
  store_.begin();
  divider_.reset();
  list_.reset();
  group_ = {};
  square_.reset();
  clocks_ = {};
  state_ = {};
  frame_pending_ = true;
  begun_.notify(sc_core::SC_ZERO_TIME);
}

SquareClocks CornerDivider::account(std::uint64_t clocks) const {
  SquareClocks all = receiver_.clocks();
  for (const SquareActivity one : {SquareActivity::working, SquareActivity::waiting_for_renderer})
    all.add(one, clocks_.of(one));
  return complete_clocks(all, SquareActivity::done, clocks);
}

DividerStatus CornerDivider::status() const { return {state_.empty() ? "receiving" : state_, square_}; }

void CornerDivider::work() {
  while (true) {
    if (!std::exchange(frame_pending_, false)) {
      wait(begun_);
      frame_pending_ = false;
    }
    wait(receiver_.received());
    if (assigned_.empty()) {
      state_ = name_of(SquareActivity::done);
      continue;
    }
    receive_model();
    SteppedDatapath path(header_, memory_, machine_, remote_planes_, callbacks());
    for (const std::size_t square : assigned_) divide(square, path);
    wait_spent();
    square_.reset();
    state_ = name_of(SquareActivity::done);
  }
}

/// The boxes of the tree's nodes are computed while the model is received, and written to the node memory after its
/// last word.
void CornerDivider::receive_model() {
  constexpr unsigned byte_bits = 8;
  const division::DisplayModel model = division::from_link(receiver_.bytes(), byte_bits);
  header_ = model.header();
  memory_ = division::ModelMemory(model, figures_.record_bits);
  remote_planes_ = has_remote_planes(receiver_.bytes().size(), model.planes.size(), memory_.plane_bits(), figures_);
  state_ = "testing";
  divider_.emplace(model);
  spend(model.nodes.size() * figures_.node_clocks);
}

void CornerDivider::divide(std::size_t square, SteppedDatapath& path) {
  wait_spent();
  square_ = square;
  begun_square_ = false;
  state_ = "testing";
  const isa::Region& region = squares_[square];
  if (figures_.levels == 2 && enclosing_group(region) != group_) begin_group(enclosing_group(region), path);
  path.set_level(list_ ? Level::listed : Level::whole);
  divider_->divide(region, list_ ? *list_ : divider_->all(), path);
  if (begun_square_) return store(isa::SegmentEnd{}, true);
  store(StoredWord{.word = {}, .is_clear = true, .is_last = true});
}

void CornerDivider::begin_group(const isa::Region& group, SteppedDatapath& path) {
  group_ = group;
  path.set_level(Level::group);
  list_ = divider_->survivors(group, path);
  path.take_counts();
  const std::uint64_t entries = list_->entry_count();
  spend(std::min<std::uint64_t>(entries, figures_.list_entries));
  if (entries > figures_.list_entries) list_.reset();
}

isa::Region CornerDivider::enclosing_group(const isa::Region& square) const {
  const std::uint32_t width = figures_.group_side * machine_.array.width;
  const std::uint32_t height = figures_.group_side * machine_.array.height;
  const std::uint32_t x = square.x / width * width;
  const std::uint32_t y = square.y / height * height;
  return {x, y, std::min(width, picture_.width - x), std::min(height, picture_.height - y)};
}

bool CornerDivider::are_in_same_group(const isa::Region& first, const isa::Region& second) const {
  return figures_.levels == 2 && enclosing_group(first) == enclosing_group(second);
}

SteppedDatapath::Callbacks CornerDivider::callbacks() {
  return {.spend = [this](std::uint64_t clocks) { spend(clocks); },
          .store_command =
              [this](const isa::Instruction& instruction) {
                if (!std::exchange(begun_square_, true)) store(isa::SegmentStart{squares_[*square_]}, false);
                store(instruction, false);
              }};
}

/// The clocks elapse in wait_spent(), before the divider's next externally visible action.
void CornerDivider::spend(std::uint64_t clocks) {
  clocks_.add(SquareActivity::working, clocks);
  spent_ += clocks;
}

void CornerDivider::wait_spent() {
  if (spent_ > 0) wait(sc_core::sc_time::from_value(std::exchange(spent_, 0) * period_.value()));
}

void CornerDivider::store(const isa::Command& command, bool is_last) {
  std::vector<StoredWord> words;
  isa::encode(command, machine_.link.width, [&](const isa::LinkWord& word) { words.push_back({.word = word}); });
  words.back().is_last = is_last;
  wait_spent();
  state_ = "writing";
  if (store_.has_room_for(words.size())) {
    store_at_once(words);
  } else {
    for (const StoredWord& word : words) store(word);
  }
  state_ = "testing";
}

/// Writes one word per clock; the store has room for all of them.
void CornerDivider::store_at_once(std::span<const StoredWord> words) {
  std::uint64_t edge = systemc::edges(period_);
  for (const StoredWord& word : words) store_.write(word, ++edge);
  spend(words.size());
  wait_spent();
}

/// Writes the word in the next clock, or in the first later clock in which the store has room.
void CornerDivider::store(const StoredWord& word) {
  spend(1);
  wait_spent();
  while (!store_.has_room()) {
    const std::string_view before = std::exchange(state_, name_of(SquareActivity::waiting_for_renderer));
    const std::uint64_t start_clock = systemc::edges(period_);
    if (!store_.has_room_next()) wait(store_.freed());
    wait(period_);
    clocks_.add(SquareActivity::waiting_for_renderer, systemc::edges(period_) - start_clock);
    state_ = before;
  }
  store_.write(word);
}

}  // namespace csgsim::pixel_square
