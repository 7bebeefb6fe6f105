#include "hw/array/step_log.h"

#include <algorithm>
#include <array>

namespace csgsim::array {

namespace {

constexpr unsigned longest_run = 64;

/// A function separated from its initial carry.
struct Parted {
  AluFunction rest = AluFunction::idle;
  CarryIn carry = CarryIn::keep;
};

constexpr auto parted = [] {
  std::array<Parted, std::size(alu_table)> table;
  for (std::size_t i = 0; i < table.size(); ++i) table[i].rest = static_cast<AluFunction>(i);
  const auto part = [&](AluFunction function, AluFunction rest, CarryIn carry) {
    table[static_cast<std::size_t>(function)] = {rest, carry};
  };
  part(AluFunction::compare_from_0, AluFunction::compare, CarryIn::zero);
  part(AluFunction::compare_from_1, AluFunction::compare, CarryIn::one);
  part(AluFunction::less_from_0, AluFunction::less, CarryIn::zero);
  part(AluFunction::less_from_1, AluFunction::less, CarryIn::one);
  part(AluFunction::sum_from_0, AluFunction::sum, CarryIn::zero);
  part(AluFunction::sum_with_1_from_0, AluFunction::sum_with_1, CarryIn::zero);
  part(AluFunction::difference_from_1, AluFunction::difference, CarryIn::one);
  return table;
}();

/// Whether `next` extends `run` by one step.
bool continues(const Run& run, const Run& next) {
  if (run.function != next.function || next.carry_in != CarryIn::keep || run.latches != next.latches ||
      run.from_tree != next.from_tree || run.count == longest_run) {
    return false;
  }
  const AluInfo& row = info(run.function);
  const auto follows = [&](unsigned first, unsigned bit) { return first + run.count == bit; };
  if (row.reads_x && run.from_tree && (run.stream != next.stream || !follows(run.stream_bit, next.stream_bit)))
    return false;
  if (row.reads_x && !run.from_tree && !follows(run.x, next.x)) return false;
  const bool writes = row.writes || run.function == AluFunction::latch_x;
  return (!row.reads_y || follows(run.y, next.y)) && (!writes || follows(run.write, next.write)) &&
         (row.reads_x || row.reads_y || writes);
}

}  // namespace

void Batch::clear() {
  runs.clear();
  streams.clear();
  reads.clear();
  writes.clear();
  carry = Touch::none;
  latch = Touch::none;
  flag = Touch::none;
  acts_where_disabled = false;
}

void StepLog::push(const ArrayStep& step, const StreamBit* tree) {
  if (step.function == AluFunction::idle || step.function == AluFunction::answer) return;
  const bool latches = is_latch_repeated(step);
  ArrayStep one = step;
  if (latches) {
    one.source = OperandSource::memory;
    one.x = static_cast<std::uint16_t>(batch_.runs.back().x - bits_.memory(0));
    batch_.runs.pop_back();
  }
  for (unsigned bit = 0; bit < processed_bits(one); ++bit) push_bit(one, bit, tree, latches);
}

/// Whether the previous step read operand x, a single bit, from memory into the latch, so that both steps can be
/// merged.
bool StepLog::is_latch_repeated(const ArrayStep& step) const {
  if (step.source != OperandSource::latch || step.bits != 1 || batch_.runs.empty()) return false;
  if (!info(function_of_bit(step, 0)).reads_x) return false;
  const Run& before = batch_.runs.back();
  return before.function == AluFunction::latch_x && before.count == 1 && !before.from_tree && bits_.alu_bits == 1;
}

void StepLog::push_bit(const ArrayStep& step, unsigned bit, const StreamBit* tree, bool latches) {
  Run run{.count = 1};
  const auto [rest, carry] = parted[static_cast<std::size_t>(function_of_bit(step, bit))];
  run.function = rest;
  run.carry_in = carry;
  const AluInfo& row = info(run.function);
  run.constant = step.constant >> bit & 1U;
  if (row.reads_x) {
    run.latches = latches;
    run.from_tree = step.source == OperandSource::tree && tree != nullptr;
    if (run.from_tree) {
      run.stream = find_or_add_stream(*tree);
      const int first = (tree->token.active() ? tree->token.bit : 0) + step.first;
      run.stream_bit = static_cast<std::uint16_t>(first + static_cast<int>(bit));
    } else if (step.source == OperandSource::tree) {
      run.x = static_cast<std::uint16_t>(bits_.tree(step.first + bit));
    } else {
      run.x = static_cast<std::uint16_t>(step.source == OperandSource::latch ? bits_.latch(bit)
                                                                             : bits_.memory(step.x + bit));
    }
  }
  if (row.reads_y) run.y = static_cast<std::uint16_t>(bits_.memory(step.y + bit));
  if (row.writes) run.write = static_cast<std::uint16_t>(bits_.memory(step.write + bit));
  if (run.function == AluFunction::latch_x) run.write = static_cast<std::uint16_t>(bits_.latch(bit));
  append(run);
}

void StepLog::append(const Run& run) {
  record_accesses(run);
  if (batch_.runs.empty() || !continues(batch_.runs.back(), run)) {
    batch_.runs.push_back(run);
    return;
  }
  Run& last = batch_.runs.back();
  last.constant |= run.constant << last.count;
  ++last.count;
}

void StepLog::record_accesses(const Run& run) {
  const AluInfo& row = info(run.function);
  const auto first_touch = [](Touch& touch, bool sets) {
    if (touch == Touch::none) touch = sets ? Touch::sets : Touch::uses;
  };
  if (row.has_carry) first_touch(batch_.carry, run.carry_in != CarryIn::keep);
  if (row.has_flag) first_touch(batch_.flag, run.function == AluFunction::root_first);
  if (run.function == AluFunction::latch_x || run.latches) first_touch(batch_.latch, bits_.alu_bits == 1);
  if (row.reads_x && !run.from_tree && run.x < bits_.memory(0)) batch_.latch = Touch::uses;
  batch_.acts_where_disabled = batch_.acts_where_disabled || row.acts_where_disabled;
  if (row.reads_x && !run.from_tree) batch_.reads.add(run.x);
  if (row.reads_y) batch_.reads.add(run.y);
  if (row.writes) batch_.writes.add(run.write);
}

/// Streams whose coefficients agree in all bits that are valid in both are treated as one, because their bits are the
/// same.
std::uint16_t StepLog::find_or_add_stream(const StreamBit& tree) {
  const Token all{.bit = 0, .bits = static_cast<std::uint16_t>(bits_.alu_bits)};
  const StreamBit bits = tree.token.active() ? tree : StreamBit{.token = all};
  const unsigned known = static_cast<unsigned>(bits.token.bit) + bits.token.bits;
  if (!batch_.streams.empty()) {
    Stream& last = batch_.streams.back();
    const std::uint64_t both = low_bits(std::min(known, last.bits));
    const std::uint64_t differs = (last.a ^ bits.a) | (last.b ^ bits.b) | (last.c ^ bits.c) | (last.xx ^ bits.xx) |
                                  (last.xy ^ bits.xy) | (last.yy ^ bits.yy);
    const bool agrees = (differs & both) == 0;
    if (agrees && known <= last.bits) return static_cast<std::uint16_t>(batch_.streams.size() - 1);
    if (agrees) {
      last = {bits.a, bits.b, bits.c, bits.xx, bits.xy, bits.yy, known};
      return static_cast<std::uint16_t>(batch_.streams.size() - 1);
    }
  }
  batch_.streams.push_back({bits.a, bits.b, bits.c, bits.xx, bits.xy, bits.yy, known});
  return static_cast<std::uint16_t>(batch_.streams.size() - 1);
}

}  // namespace csgsim::array
