#include "hw/scan_line/chain.h"

#include <algorithm>
#include <stdexcept>

namespace csgsim::scan_line {

namespace {

constexpr std::uint32_t plane_bits = 64;

/// Beat in which a cell begins to hold a pixel of the line.
std::uint32_t clearing_beat(const Packet& packet) {
  return packet.kind == PacketKind::clear && !packet.begins_line ? packet.beats - 1 : 0;
}

bool clears(const Packet& packet) { return packet.begins_line || packet.kind == PacketKind::clear; }

}  // namespace

Chain::Chain(std::uint32_t cells, std::uint32_t memory_bits, const CellShape& shape)
    : network_(shape.tree_bits > 0 ? Network::trees : Network::chain),
      shape_(shape),
      cells_(cells, memory_bits),
      flights_(cells),
      sums_before_(cells),
      shift_(cells) {}

void Chain::begin(std::uint32_t line_pixels) {
  catch_up(pixels_ - 1);
  for (std::uint32_t cell = 0; cell < pixels_; ++cell) sums_before_[cell] = sum(cell);
  last_f_packet_.reset();
  cleared_.reset();
  pixels_ = line_pixels;
  oldest_ = 0;
  count_ = 0;
  shifting_ = false;
  held_ = false;
  transfers_ = false;
  departure_ = {};
  departed_snapshot_ = no_snapshot;
  snapshots_.clear();
  unused_.clear();
  next_beat_ = 0;
}

void Chain::step(const Beat& entering) {
  shift();
  transfer();
  accept_beat(entering);
  ++clock_;
  depart();
}

RefreshPixel Chain::refresh() const {
  if (!shifting_) return {};
  return {.valid = true, .colour = shift_[shifted_]};
}

Beat Chain::beat_in(std::uint32_t cell) const {
  for (std::size_t i = 0; i < count_; ++i) {
    const Flight& one = flight(i);
    const std::uint64_t first = one.entered + clocks_to(cell);
    if (clock_ >= first && clock_ < first + one.packet.beats)
      return {&one.packet, static_cast<std::uint32_t>(clock_ - first)};
  }
  return {};
}

std::optional<std::uint32_t> Chain::segment_of(std::uint32_t cell) const {
  for (std::size_t i = count_; i > 0; --i) {
    const Flight& one = flight(i - 1);
    if (clears(one.packet) && beats_executed(one, cell) > clearing_beat(one.packet)) return one.packet.segment;
  }
  return cleared_;
}

std::uint64_t Chain::sum(std::uint32_t cell) const {
  for (std::size_t i = count_; i > 0; --i) {
    const Flight& one = flight(i - 1);
    const std::uint32_t beats = beats_executed(one, cell);
    if (one.packet.brings_f() && beats > 0) return received_sum(one.packet, beats, cell, shape_);
  }
  return last_f_packet_ ? received_sum(*last_f_packet_, last_f_packet_->words, cell, shape_) : sums_before_[cell];
}

bool Chain::enabled(std::uint32_t cell) const {
  catch_up(cell);
  return cells_.enabled(cell);
}

std::uint32_t Chain::held(std::uint32_t cell) const {
  catch_up(cell);
  return cells_.held(cell);
}

std::uint64_t Chain::read(std::uint32_t cell, isa::Field field) const {
  catch_up(cell);
  return cells_.read(cell, field);
}

void Chain::shift() {
  if (shifting_) shifting_ = ++shifted_ < pixels_;
}

void Chain::transfer() {
  if (!transfers_) return;
  if (shifting_) throw std::logic_error("a line reached the refresh path before the previous line had left it");
  for (std::uint32_t cell = 0; cell < pixels_; ++cell) shift_[cell] = cells_.held(cell);
  shifted_ = 0;
  shifting_ = true;
  transfers_ = false;
  held_ = false;
}

void Chain::accept_beat(const Beat& beat) {
  if (beat.number != next_beat_) throw std::logic_error("a packet does not enter beat by beat");
  if (beat.packet == nullptr) return;
  if (beat.number == 0) take(*beat.packet);
  next_beat_ = beat.last() ? 0 : beat.number + 1;
  if (network_ == Network::chain && beat.packet->kind == PacketKind::mark && beat.last()) hold();
}

void Chain::take(const Packet& packet) {
  Flight& entering = flight(count_++);
  entering.packet = packet;
  compute_steps(packet, shape_, entering.steps);
  entering.entered = clock_;
  entering.done_cells.clear();
  entering.enabled = 0;
  entering.snapshot = packet.keep != Keep::nothing ? take_snapshot(packet.keep) : no_snapshot;
}

/// Called when a mark reaches the first cell.
void Chain::hold() {
  if (held_) throw std::logic_error("a mark reached hold registers that the refresh path had not read");
  held_ = true;
}

/// Completes the oldest packet, which has advanced farthest, when it leaves the last cell.
void Chain::depart() {
  if (departed_snapshot_ != no_snapshot) unused_.push_back(departed_snapshot_);
  departed_snapshot_ = no_snapshot;
  departure_ = {};
  if (count_ == 0) return;
  Flight& leaving = flight(0);
  const Packet& packet = leaving.packet;
  if (clock_ < leaving.entered + packet.beats + clocks_to(pixels_ - 1)) return;
  finish(leaving);
  const bool is_instruction = packet.kind == PacketKind::instruction;
  departed_snapshot_ = leaving.snapshot;
  departure_ = {.kind = packet.kind,
                .segment = packet.segment,
                .index = packet.index,
                .enabled_pixels = leaving.enabled,
                .busy_cells = is_instruction ? std::uint64_t{packet.beats} * pixels_ : 0,
                .snapshot = leaving.snapshot == no_snapshot ? nullptr : &snapshots_[leaving.snapshot]};
  if (packet.kind == PacketKind::mark) {
    if (network_ == Network::trees) hold();
    transfers_ = true;
  }
  if (packet.brings_f()) last_f_packet_ = packet;
  if (clears(packet)) cleared_ = packet.segment;
  oldest_ = oldest_ + 1 == flights_.size() ? 0 : oldest_ + 1;
  --count_;
}

Chain::Flight& Chain::flight(std::size_t index) const {
  const std::size_t place = oldest_ + index;
  return flights_[place < flights_.size() ? place : place - flights_.size()];
}

/// Number of the packet's beats that have been in the cell.
std::uint32_t Chain::beats_executed(const Flight& flight, std::uint32_t cell) const {
  const std::uint64_t first = flight.entered + clocks_to(cell);
  if (clock_ <= first) return 0;
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(clock_ - first, flight.packet.beats));
}

/// Number of cells that the beat has visited.
std::uint32_t Chain::cells_reached(const Flight& flight, std::uint32_t beat) const {
  const std::uint64_t entered = flight.entered + beat;
  if (network_ == Network::trees) return clock_ > entered + clocks_to(0) ? pixels_ : 0;
  return clock_ > entered ? static_cast<std::uint32_t>(std::min<std::uint64_t>(clock_ - entered, pixels_)) : 0;
}

/// Executes all pending beats in the cell and in the cells before it.
void Chain::catch_up(std::uint32_t cell) const {
  for (std::size_t i = 0; i < count_; ++i) {
    Flight& one = flight(i);
    if (!one.done_cells.empty() && one.done_cells.back() > cell) continue;
    const std::uint32_t beats = beats_executed(one, cell);
    if (beats > 0) one.done_cells.resize(one.packet.beats);
    for (std::uint32_t beat = 0; beat < beats; ++beat)
      catch_up(one, beat, std::min(cell + 1, cells_reached(one, beat)));
  }
}

/// Executes the beat in the cells before `end_cell` that have not executed it.
void Chain::catch_up(Flight& flight, std::uint32_t beat, std::uint32_t end_cell) const {
  std::uint32_t& done = flight.done_cells[beat];
  if (done >= end_cell) return;
  const CellRange range{done, end_cell};
  flight.enabled += cells_.execute(flight.packet, std::span(flight.steps).subspan(beat, 1), range);
  if (beat + 1 == flight.packet.beats) record_snapshot(flight, range);
  done = end_cell;
}

/// Executes the packet completely in all cells of the line.
void Chain::finish(Flight& flight) {
  if (flight.done_cells.empty()) {
    flight.enabled += cells_.execute_all(flight.packet, flight.steps, {0, pixels_});
    return record_snapshot(flight, {0, pixels_});
  }
  for (std::uint32_t beat = 0; beat < flight.packet.beats; ++beat) catch_up(flight, beat, pixels_);
}

void Chain::record_snapshot(const Flight& flight, CellRange range) const {
  if (flight.snapshot == no_snapshot) return;
  Snapshot& snapshot = snapshots_[flight.snapshot];
  cells_.add_enabled(range, snapshot.enable);
  if (flight.packet.keep != Keep::all) return;
  for (std::size_t word = 0; word < snapshot.cell_words; ++word)
    for (std::uint32_t cell = range.first; cell < range.end; ++cell)
      snapshot.memory[cell * snapshot.cell_words + word] = cells_.memory_word(cell, word);
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
