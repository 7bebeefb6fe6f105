#include "hw/scan_line/cell_steps.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include "hw/isa/opcodes.h"

namespace csgsim::scan_line {

namespace {

/// Schedule of the memory ports: the words that they access in consecutive clocks.
class Ports {
 public:
  explicit Ports(const CellShape& cell) : cell_(cell) {}

  /// Index after the words accessed in the next clock, if `done` of `words` words have been accessed.
  [[nodiscard]] std::uint32_t end(std::uint32_t done, std::uint32_t words) const {
    return cell_.ports == 0 ? words : std::min(words, done + cell_.ports);
  }

  /// Part of the field in words [first, end) of its words.
  [[nodiscard]] FieldPart part(const FieldWords& words, std::uint32_t first, std::uint32_t end) const {
    if (first >= end) return {};
    const std::uint32_t begins = std::max<std::uint32_t>(words.field.base, (words.first + first) * cell_.word_bits);
    const std::uint32_t ends = std::min<std::uint32_t>(words.field.end(), (words.first + end) * cell_.word_bits);
    return {{static_cast<std::uint16_t>(begins), static_cast<std::uint16_t>(ends - begins)}, begins - words.field.base};
  }

 private:
  const CellShape& cell_;
};

/// Progress of the ports through a packet's sources, read one after the other.
class ReadProgress {
 public:
  ReadProgress(const Accesses& accesses, const CellShape& cell)
      : sources_(accesses.sources), ports_(cell), words_(sources_[0].count + std::uint32_t{sources_[1].count}) {}

  [[nodiscard]] bool done() const { return done_ == words_; }

  std::array<FieldPart, 2> clock() {
    const std::uint32_t first = done_;
    done_ = ports_.end(done_, words_);
    const std::uint32_t of_first = sources_[0].count;
    const auto of_second = [&](std::uint32_t word) { return std::max(word, of_first) - of_first; };
    return {ports_.part(sources_[0], first, std::min(done_, of_first)),
            ports_.part(sources_[1], of_second(first), of_second(done_))};
  }

 private:
  const std::array<FieldWords, 2>& sources_;
  Ports ports_;
  std::uint32_t words_;
  std::uint32_t done_ = 0;
};

/// Progress of shifter and ALU through the operands.
class WorkProgress {
 public:
  WorkProgress(const CellWork& work, const CellShape& cell) : work_(work), cell_(cell) { skip_moves(); }

  [[nodiscard]] bool done() const { return move_ == work_.moves.size() && taken_ == work_.bits; }

  /// Moves one word, or, once all words are aligned, processes the ALU's next bits.
  AluBits clock() {
    if (move_ < work_.moves.size()) {
      advance_move();
      return {};
    }
    const AluBits taken{taken_, std::min(alu_width(cell_, work_.bits), work_.bits - taken_)};
    taken_ += taken.count;
    return taken;
  }

 private:
  void skip_moves() {
    while (move_ < work_.moves.size() && (cell_.shift_bits == 0 || work_.moves.at(move_).distance == 0)) ++move_;
  }

  void advance_move() {
    const Move& move = work_.moves.at(move_);
    moved_ += cell_.shift_bits;
    if (moved_ < move.distance) return;
    moved_ = 0;
    if (++word_ < move.words) return;
    word_ = 0;
    ++move_;
    skip_moves();
  }

  const CellWork& work_;
  const CellShape& cell_;
  std::size_t move_ = 0;     ///< index of the current move
  std::uint32_t word_ = 0;   ///< word of the moved operand
  std::uint32_t moved_ = 0;  ///< bits by which that word has moved
  std::uint32_t taken_ = 0;  ///< bits that the ALU has processed
};

/// Progress of a root: bit k is tried with a sum of k + 3 bits.
class RootProgress {
 public:
  RootProgress(const Packet& packet, const CellShape& cell)
      : cell_(cell),
        bits_(packet.instruction.opcode == isa::Opcode::root ? packet.accesses.target.field.width / 2U : 0) {}

  [[nodiscard]] bool done() const { return bit_ == bits_; }

  void clock(CellStep& step) {
    if (done()) return;
    const std::uint32_t length = bit_ + 3;
    step.begins_root = bit_ == 0 && tried_ == 0;
    step.root_bit = bit_;
    step.trial = {tried_, std::min(alu_width(cell_, cell_.word_bits), length - tried_)};
    tried_ += step.trial.count;
    if (tried_ < length) return;
    tried_ = 0;
    ++bit_;
  }

 private:
  const CellShape& cell_;
  std::uint32_t bits_;
  std::uint32_t bit_ = 0;
  std::uint32_t tried_ = 0;
};

void require(bool done, const char* what) {
  if (!done) throw std::logic_error(what);
}

void find_instruction_steps(const Packet& packet, const CellShape& cell, std::vector<CellStep>& steps) {
  const Accesses& accesses = packet.accesses;
  const Ports ports(cell);
  ReadProgress read_progress(accesses, cell);
  WorkProgress work_progress(packet.work, cell);
  RootProgress root_progress(packet, cell);
  std::uint32_t written = 0;
  for (std::uint32_t number = 0; number < packet.beats; ++number) {
    CellStep& step = steps[number];
    step.reads = read_progress.clock();
    if (number >= accesses.work_from && number <= accesses.result) {
      root_progress.clock(step);
      step.alu = work_progress.clock();
    }
    if (number < accesses.result) continue;
    if (number == accesses.result) {
      require(read_progress.done(), "a cell acts before its ports have read the fields");
      require(work_progress.done(), "a cell acts before its shifter and ALU have finished");
      require(root_progress.done(), "a cell acts before it has found all bits of a root");
      step.acts = true;
    }
    const std::uint32_t first = written;
    written = ports.end(written, accesses.target.count);
    step.writes = ports.part(accesses.target, first, written);
  }
}

}  // namespace

void compute_steps(const Packet& packet, const CellShape& cell, std::vector<CellStep>& steps) {
  steps.assign(packet.beats, {});
  steps.front().clears = packet.begins_line;
  switch (packet.kind) {
    case PacketKind::none: break;
    case PacketKind::clear: steps.back().clears = true; break;
    case PacketKind::instruction: find_instruction_steps(packet, cell, steps); break;
    case PacketKind::mark: {
      ReadProgress read_progress(packet.accesses, cell);
      for (CellStep& step : steps) step.reads = read_progress.clock();
      steps.back().holds = true;
      break;
    }
  }
}

}  // namespace csgsim::scan_line
