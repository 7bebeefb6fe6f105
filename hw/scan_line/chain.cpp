#include "hw/scan_line/chain.h"

#include <algorithm>
#include <stdexcept>

#include "hw/isa/opcodes.h"

namespace csgsim::scan_line {

namespace {

constexpr std::uint32_t plane_bits = 64;

}  // namespace

Chain::Chain(std::uint32_t cells, std::uint32_t memory_bits, const CellShape& shape)
    : network_(shape.tree_bits > 0 ? Network::trees : Network::chain),
      cells_(cells, memory_bits, shape),
      flights_(cells),
      segment_of_(cells),
      hold_(cells),
      shift_(cells) {}

void Chain::begin(std::uint32_t pixels) {
  pixels_ = pixels;
  std::fill(segment_of_.begin(), segment_of_.end(), std::nullopt);
  oldest_ = 0;
  count_ = 0;
  shifting_ = false;
  held_ = false;
  transfers_ = false;
  departure_ = {};
  departed_snapshot_ = no_snapshot;
  snapshots_.clear();
  unused_.clear();
  due_ = 0;
  busy_ = 0;
}

void Chain::step(const PacketWord& entering) {
  shift();
  transfer();
  enter(entering);
  const std::size_t until_wrap = std::min(count_, flights_.size() - oldest_);
  for (std::size_t i = 0; i < until_wrap; ++i) move(flights_[oldest_ + i]);
  for (std::size_t i = 0; i < count_ - until_wrap; ++i) move(flights_[i]);
  depart();
}

RefreshPixel Chain::refresh() const {
  if (!shifting_) return {};
  return {.valid = true, .colour = shift_[shifted_]};
}

const PacketWord* Chain::beat_in(std::uint32_t cell) const {
  for (std::size_t i = 0; i < count_; ++i) {
    const std::size_t place = oldest_ + i;
    const Flight& flight = flights_[place < flights_.size() ? place : place - flights_.size()];
    if (flight.moved == clocks_to(cell)) return &flight.word;
  }
  return nullptr;
}

void Chain::shift() {
  if (shifting_) shifting_ = ++shifted_ < pixels_;
}

void Chain::transfer() {
  if (!transfers_) return;
  if (shifting_) throw std::logic_error("a line came to the refresh path before the line ahead had left it");
  std::copy_n(hold_.begin(), pixels_, shift_.begin());
  shifted_ = 0;
  shifting_ = true;
  transfers_ = false;
  held_ = false;
}

void Chain::enter(const PacketWord& word) {
  if (word.number != due_) throw std::logic_error("a packet does not enter beat by beat");
  if (word.kind == WordKind::none) return;
  due_ = word.last() ? 0 : word.number + 1;
  const std::size_t place = oldest_ + count_;
  flights_[place < flights_.size() ? place : place - flights_.size()] = {
      .word = word, .snapshot = word.last() && word.keep != Keep::nothing ? take_snapshot(word.keep) : no_snapshot};
  ++count_;
}

void Chain::move(Flight& flight) {
  if (flight.moved == clocks_to(0) && flight.word.kind == WordKind::mark && flight.word.last()) hold();
  if (network_ == Network::chain) {
    work(flight, flight.moved);
  } else if (flight.moved == clocks_to(0)) {
    for (std::uint32_t cell = 0; cell < pixels_; ++cell) work(flight, cell);
  }
  ++flight.moved;
}

/// A mark comes to the first cell.
void Chain::hold() {
  if (held_) throw std::logic_error("a mark came to hold registers that the refresh path had not read");
  held_ = true;
}

void Chain::work(Flight& flight, std::uint32_t cell) {
  const PacketWord& beat = flight.word;
  if (beat.begins_line && beat.number == 0) clear(flight, cell);
  switch (beat.kind) {
    case WordKind::none: break;
    case WordKind::clear:
      if (beat.last()) clear(flight, cell);
      break;
    case WordKind::instruction: work_on_instruction(flight, cell); break;
    case WordKind::mark: work_on_mark(flight, cell); break;
  }
  if (flight.snapshot != no_snapshot) take_down(flight, cell);
}

void Chain::clear(const Flight& flight, std::uint32_t cell) {
  cells_.clear(cell);
  segment_of_[cell] = flight.word.segment;
}

void Chain::work_on_instruction(Flight& flight, std::uint32_t cell) {
  PacketWord& beat = flight.word;
  ++flight.busy;
  if (beat.number < beat.words && beat.instruction.linear.width > 0) {
    if (network_ == Network::chain) {
      cells_.add(cell, beat);
    } else {
      cells_.take(cell, beat);
    }
  }
  cells_.fetch(cell, beat);
  const bool is_root = beat.instruction.opcode == isa::Opcode::root;
  if (beat.number >= beat.accesses.work_from && beat.number <= beat.accesses.result) {
    if (is_root) cells_.try_root(cell, beat);
    cells_.work(cell, beat);
  }
  if (beat.number == beat.accesses.result) {
    flight.enabled += cells_.enabled(cell) ? 1U : 0U;
    cells_.act(cell, beat);
  }
  if (beat.number >= beat.accesses.result) cells_.store(cell, beat);
}

void Chain::work_on_mark(const Flight& flight, std::uint32_t cell) {
  const PacketWord& mark = flight.word;
  cells_.fetch(cell, mark);
  if (!mark.last()) return;
  hold_[cell] = static_cast<std::uint32_t>(mark.background ? mark.instruction.constant : cells_.fetched(cell));
}

void Chain::take_down(const Flight& flight, std::uint32_t cell) {
  Snapshot& snapshot = snapshots_[flight.snapshot];
  if (cells_.enabled(cell)) {
    snapshot.enable[cell / plane_bits] |= std::uint64_t{1} << cell % plane_bits;
  }
  if (flight.word.keep != Keep::all) return;
  const std::span<const std::uint64_t> memory = cells_.memory(cell);
  std::copy(memory.begin(), memory.end(), &snapshot.memory[cell * snapshot.cell_words]);
}

/// The oldest word is the one that has come farthest.
void Chain::depart() {
  if (departed_snapshot_ != no_snapshot) unused_.push_back(departed_snapshot_);
  departed_snapshot_ = no_snapshot;
  departure_ = {};
  if (count_ == 0 || flights_[oldest_].moved <= clocks_to(pixels_ - 1)) return;
  const Flight& flight = flights_[oldest_];
  if (flight.word.number == flight.word.accesses.result) enabled_ = flight.enabled;
  busy_ += flight.busy;
  if (flight.word.last()) {
    departed_snapshot_ = flight.snapshot;
    departure_ = {.kind = flight.word.kind,
                  .segment = flight.word.segment,
                  .index = flight.word.index,
                  .enabled_pixels = enabled_,
                  .busy_cells = busy_,
                  .snapshot = flight.snapshot == no_snapshot ? nullptr : &snapshots_[flight.snapshot]};
    if (flight.word.kind == WordKind::mark) transfers_ = true;
    busy_ = 0;
  }
  oldest_ = oldest_ + 1 == flights_.size() ? 0 : oldest_ + 1;
  --count_;
}

std::size_t Chain::take_snapshot(Keep keep) {
  if (unused_.empty()) {
    unused_.push_back(snapshots_.size());
    snapshots_.emplace_back();
  }
  const std::size_t number = unused_.back();
  unused_.pop_back();
  Snapshot& snapshot = snapshots_[number];
  snapshot.cell_words = cells_.cell_words();
  snapshot.enable.assign((pixels_ + plane_bits - 1) / plane_bits, 0);
  snapshot.memory.resize(keep == Keep::all ? pixels_ * snapshot.cell_words : 0);
  return number;
}

}  // namespace csgsim::scan_line
