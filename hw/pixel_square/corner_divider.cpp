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
      figures_(machines::own<Figures>(machine_)),
      period_(systemc::period_of(machine)),
      receiver_(receiver),
      store_(machine) {
  SC_HAS_PROCESS(CornerDivider);
  SC_THREAD(work);
}

void CornerDivider::begin(const machines::Size& picture, std::span<const isa::Region> squares,
                          std::vector<std::size_t> own) {
  picture_ = picture;
  squares_ = squares;
  own_ = std::move(own);
  store_.begin();
  divider_.reset();
  list_.reset();
  group_ = {};
  square_.reset();
  clocks_ = {};
  state_ = {};
  is_begun_ = true;
  begun_.notify(sc_core::SC_ZERO_TIME);
}

SquareClocks CornerDivider::account(std::uint64_t clocks) const {
  SquareClocks all = receiver_.clocks();
  for (const SquareActivity one : {SquareActivity::working, SquareActivity::waiting_for_renderer})
    all.add(one, clocks_.of(one));
  return whole(all, SquareActivity::done, clocks);
}

DividerStatus CornerDivider::status() const { return {state_.empty() ? "receiving" : state_, square_}; }

void CornerDivider::work() {
  while (true) {
    if (!std::exchange(is_begun_, false)) {
      wait(begun_);
      is_begun_ = false;
    }
    wait(receiver_.received());
    if (own_.empty()) {
      state_ = name_of(SquareActivity::done);
      continue;
    }
    take_model();
    SteppedDatapath path(header_, memory_, machine_, far_planes_, ends());
    for (const std::size_t square : own_) divide(square, path);
    let_pass();
    square_.reset();
    state_ = name_of(SquareActivity::done);
  }
}

/// The boxes of the tree's nodes are worked out as they come, and go to their memory behind the last.
void CornerDivider::take_model() {
  constexpr unsigned byte_bits = 8;
  const division::DisplayModel model = division::from_link(receiver_.bytes(), byte_bits);
  header_ = model.header();
  memory_ = division::ModelMemory(model, figures_.record_bits);
  far_planes_ = has_far_planes(receiver_.bytes().size(), model.planes.size(), memory_.plane_bits(), figures_);
  state_ = "testing";
  divider_.emplace(model);
  spend(model.nodes.size() * figures_.node_clocks);
}

void CornerDivider::divide(std::size_t square, SteppedDatapath& path) {
  let_pass();
  square_ = square;
  begun_square_ = false;
  state_ = "testing";
  const isa::Region& region = squares_[square];
  if (figures_.levels == 2 && group_of(region) != group_) begin_group(group_of(region), path);
  path.enter(list_ ? Level::listed : Level::whole);
  divider_->divide(region, list_ ? *list_ : divider_->all(), path);
  if (begun_square_) return store(isa::SegmentEnd{}, true);
  store(StoredWord{.word = {}, .is_clear = true, .is_last = true});
}

void CornerDivider::begin_group(const isa::Region& group, SteppedDatapath& path) {
  group_ = group;
  path.enter(Level::group);
  list_ = divider_->survivors(group, path);
  path.take_counts();
  const std::uint64_t entries = list_->entries();
  spend(std::min<std::uint64_t>(entries, figures_.list_entries));
  if (entries > figures_.list_entries) list_.reset();
}

isa::Region CornerDivider::group_of(const isa::Region& square) const {
  const std::uint32_t width = figures_.group_side * machine_.array.width;
  const std::uint32_t height = figures_.group_side * machine_.array.height;
  const std::uint32_t x = square.x / width * width;
  const std::uint32_t y = square.y / height * height;
  return {x, y, std::min(width, picture_.width - x), std::min(height, picture_.height - y)};
}

bool CornerDivider::are_together(const isa::Region& one, const isa::Region& other) const {
  return figures_.levels == 2 && group_of(one) == group_of(other);
}

SteppedDatapath::Ends CornerDivider::ends() {
  return {.spend = [this](std::uint64_t clocks) { spend(clocks); },
          .store_command =
              [this](const isa::Instruction& instruction) {
                if (!std::exchange(begun_square_, true)) store(isa::SegmentStart{squares_[*square_]}, false);
                store(instruction, false);
              }};
}

/// They go by when something is next seen of the divider.
void CornerDivider::spend(std::uint64_t clocks) {
  clocks_.add(SquareActivity::working, clocks);
  spent_ += clocks;
}

void CornerDivider::let_pass() {
  if (spent_ > 0) wait(sc_core::sc_time::from_value(std::exchange(spent_, 0) * period_.value()));
}

void CornerDivider::store(const isa::Command& command, bool is_last) {
  std::vector<StoredWord> words;
  isa::encode(command, machine_.link.width, [&](const isa::LinkWord& word) { words.push_back({.word = word}); });
  words.back().is_last = is_last;
  let_pass();
  state_ = "writing";
  if (store_.has_room_for(words.size())) {
    store_at_once(words);
  } else {
    for (const StoredWord& word : words) store(word);
  }
  state_ = "testing";
}

/// A clock each.
void CornerDivider::store_at_once(std::span<const StoredWord> words) {
  std::uint64_t edge = systemc::edges(period_);
  for (const StoredWord& word : words) store_.write(word, ++edge);
  spend(words.size());
  let_pass();
}

/// In the clock that it takes to write, or in the first after it in which there is room.
void CornerDivider::store(const StoredWord& word) {
  spend(1);
  let_pass();
  while (!store_.has_room()) {
    const std::string_view before = std::exchange(state_, name_of(SquareActivity::waiting_for_renderer));
    const std::uint64_t begun = systemc::edges(period_);
    if (!store_.room_follows()) wait(store_.freed());
    wait(period_);
    clocks_.add(SquareActivity::waiting_for_renderer, systemc::edges(period_) - begun);
    state_ = before;
  }
  store_.write(word);
}

}  // namespace csgsim::pixel_square
