#include "hw/scan_line/cells.h"

#include <algorithm>

#include "hw/base/quotient.h"
#include "hw/isa/opcodes.h"
#include "hw/systemc/field_bits.h"

namespace csgsim::scan_line {

namespace {

constexpr std::uint32_t storage_bits = 64;

/// Number of cells that are tested together for enabled cells.
constexpr std::uint32_t block_cells = 64;

}  // namespace

Cells::Cells(std::uint32_t count, std::uint32_t memory_bits)
    : count_(count),
      stride_(count + kernels::max_lanes),
      cell_words_(quotient_up(memory_bits, storage_bits)),
      memory_(stride_ * cell_words_),
      enable_(stride_),
      fetched_(2 * stride_),
      value_(stride_),
      flags_(stride_),
      writes_(stride_),
      hold_(count) {}

kernels::Lanes Cells::lanes() {
  return {.memory = memory_.data(),
          .stride = stride_,
          .enable = enable_.data(),
          .fetched = {fetched_.data(), fetched_.data() + stride_},
          .value = value_.data(),
          .flags = flags_.data(),
          .writes = writes_.data()};
}

std::uint64_t Cells::execute(const Packet& packet, std::span<const CellStep> steps, CellRange range) {
  if (range.first >= range.end) return 0;
  if (steps.front().clears) clear(range);
  const std::uint64_t enabled = kernels::execute(packet, steps, lanes(), range);
  if (steps.back().holds) hold(packet, range);
  return enabled;
}

std::uint64_t Cells::execute_all(const Packet& packet, std::span<const CellStep> steps, CellRange range) {
  if (packet.kind == PacketKind::clear) {
    clear(range);
    return 0;
  }
  if (packet.kind == PacketKind::mark || isa::acts_on_disabled(packet.instruction.opcode))
    return execute(packet, steps, range);
  if (packet.begins_line) {
    clear(range);
    return 0;
  }
  std::uint64_t enabled = 0;
  std::uint32_t first = range.first;  // first cell of consecutive blocks that are executed together
  for (std::uint32_t block = range.first; block < range.end;) {
    const std::uint32_t next = std::min(range.end, block + block_cells);
    if (!any_enabled({block, next})) {
      enabled += execute(packet, steps, {first, block});
      first = next;
    }
    block = next;
  }
  return enabled + execute(packet, steps, {first, range.end});
}

bool Cells::any_enabled(CellRange range) const {
  return kernels::any_ones(std::span(enable_).subspan(range.first, range.end - range.first));
}

std::uint64_t Cells::read(std::uint32_t cell, isa::Field field) const {
  if (field.width == 0) return 0;
  const std::size_t word = field.base / storage_bits;
  const std::uint64_t high = field.end() > (word + 1) * storage_bits ? memory_word(cell, word + 1) : 0;
  const std::uint64_t words[] = {memory_word(cell, word), high};
  return systemc::read_field(words, {static_cast<std::uint16_t>(field.base % storage_bits), field.width});
}

void Cells::clear(CellRange range) {
  const std::uint32_t count = range.end - range.first;
  for (std::size_t word = 0; word < cell_words_; ++word) std::fill_n(&memory_[word * stride_ + range.first], count, 0U);
  std::fill_n(&enable_[range.first], count, 0U);
}

/// The mark of a line without colours has no field; its cells hold 0.
void Cells::hold(const Packet& mark, CellRange range) {
  const bool has_colour = !mark.background && mark.accesses.sources[0].count > 0;
  const auto constant = static_cast<std::uint32_t>(mark.background ? mark.instruction.constant : 0);
  for (std::uint32_t cell = range.first; cell < range.end; ++cell)
    hold_[cell] = has_colour ? static_cast<std::uint32_t>(fetched_[cell]) : constant;
}

}  // namespace csgsim::scan_line
