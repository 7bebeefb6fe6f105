#include "hw/host/shares.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hw/base/quotient.h"
#include "hw/host/recipes.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/opcodes.h"
#include "hw/machines/kind.h"
#include "hw/machines/regions.h"

namespace csgsim::host {

namespace {

using processors::made;
using processors::Operation;
using processors::Operations;

/// The next drawing's processor found, and the end of its longs kept.
constexpr Operations drawing_merged = made({{Operation::load_long, 2},
                                            {Operation::add_long, 1},
                                            {Operation::compare, 1},
                                            {Operation::branch, 1},
                                            {Operation::store_long, 1}});
constexpr Operations long_copied = made({{Operation::load_long, 1},
                                         {Operation::store_long, 1},
                                         {Operation::add_long, 2},
                                         {Operation::compare_long, 1},
                                         {Operation::branch_taken, 1}});

bool begins_drawing(const isa::Instruction& instruction) {
  return instruction.opcode == isa::Opcode::enable_all || instruction.opcode == isa::Opcode::enable_load;
}

/// Number of drawings; instructions before the first belong to it. At least 1, for the preparation.
std::uint64_t drawings_in(const isa::Segment& segment) {
  const auto drawings = std::ranges::count_if(segment.instructions, begins_drawing);
  return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(drawings));
}

/// Drawings of the segment that has the most.
std::uint64_t most_drawings(const isa::Program& program) {
  std::uint64_t drawings = 1;
  for (const isa::Segment& segment : program.segments) drawings = std::max(drawings, drawings_in(segment));
  return drawings;
}

/// `parts` of `all` equal parts of the work, rounded up.
Operations part_of(Operations work, std::uint64_t parts, std::uint64_t all) {
  for (std::uint64_t& count : work.counts) {
    // The product of whole parts fits; that of the remainder too, since there are fewer than 2^32 drawings.
    count = count / all * parts + quotient_up(count % all * parts, all);
  }
  return work;
}

/// What each processor has taken.
class Shares {
 public:
  Shares(std::size_t processors, unsigned link_width)
      : taken_(processors, Taken{.work{}, .writer = Writer(link_width)}) {}

  /// Equal parts in turn, beginning with the first processor.
  void divide(const Operations& work, std::uint64_t parts) {
    const std::uint64_t processors = taken_.size();
    for (std::uint64_t i = 0; i < processors; ++i) {
      const std::uint64_t own = parts / processors + (i < parts % processors ? 1 : 0);
      taken_[i].work += part_of(work, own, parts);
    }
  }

  /// The drawings of a segment in turn, after those of the segments before it.
  void divide(const isa::Segment& segment) {
    const std::uint64_t drawings = drawings_in(segment);
    for (Taken& one : taken_) one.writer.begin(segment.region);
    const Operations prepared = part_of(count_operations(*segment.preparation), 1, drawings);
    bool has_begun = false;
    take(prepared);
    for (const isa::Instruction& instruction : segment.instructions) {
      if (begins_drawing(instruction)) {
        if (has_begun) {
          next();
          take(prepared);
        }
        has_begun = true;
      }
      taken_[turn_].writer.add(instruction);
    }
    next();
  }

  /// Longs and drawings of the other processors that the first one merges.
  void merge(std::uint64_t longs, std::uint64_t drawings) {
    taken_.front().work += longs * long_copied;
    taken_.front().work += drawings * drawing_merged;
  }
  void merge() {
    std::uint64_t longs = 0;
    std::uint64_t drawings = 0;
    for (std::size_t i = 1; i < taken_.size(); ++i) {
      longs += taken_[i].writer.written().longs + taken_[i].writer.written().kept_longs;
      drawings += taken_[i].drawings;
    }
    merge(longs, drawings);
  }

  [[nodiscard]] Operations largest(const processors::Processor& processor) const {
    Operations largest;
    for (const Taken& one : taken_) {
      Operations all = one.work;
      all += count_operations(one.writer.written());
      if (processors::clocks(all, processor) > processors::clocks(largest, processor)) largest = all;
    }
    return largest;
  }

 private:
  struct Taken {
    Operations work;
    Writer writer;  ///< with the words that this processor keeps
    std::uint64_t drawings = 0;
  };

  void take(const Operations& prepared) {
    taken_[turn_].work += prepared;
    ++taken_[turn_].drawings;
  }
  void next() { turn_ = (turn_ + 1) % taken_.size(); }

  std::vector<Taken> taken_;
  std::size_t turn_ = 0;
};

}  // namespace

Operations largest_share(const isa::Program& program, const machines::Machine& machine,
                         const processors::Processor& processor) {
  const std::uint64_t processors = machine.kind->hosts(machine);
  Shares shares(processors, machine.link.width);
  const std::uint64_t drawings = most_drawings(program);
  shares.divide(count_operations(*program.preparation), drawings);
  if (machines::division(machine)) {
    const std::uint64_t longs = model_longs(program);
    shares.divide(longs * model_long_operations(), drawings);
    const std::uint64_t own = quotient_up(drawings, processors);
    shares.merge(longs - std::min(longs, longs * own / drawings), drawings - own);
    return shares.largest(processor);
  }
  for (const isa::Segment& segment : program.segments) shares.divide(segment);
  shares.merge();
  return shares.largest(processor);
}

Operations largest_model_share(const isa::Program& program, const machines::Machine& machine) {
  const std::uint64_t drawings = most_drawings(program);
  const std::uint64_t own = quotient_up(drawings, std::uint64_t{machine.kind->hosts(machine)});
  return part_of(count_operations(*program.model_preparation), own, drawings);
}

}  // namespace csgsim::host
