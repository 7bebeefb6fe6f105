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

using processors::Operation;
using processors::operation_counts;
using processors::Operations;

/// Finds the processor of the next chunk, and stores the end of its longs.
constexpr Operations chunk_merged = operation_counts({{Operation::load_long, 2},
                                                      {Operation::add_long, 1},
                                                      {Operation::compare, 1},
                                                      {Operation::branch, 1},
                                                      {Operation::store_long, 1}});
constexpr Operations long_copied = operation_counts({{Operation::load_long, 1},
                                                     {Operation::store_long, 1},
                                                     {Operation::add_long, 2},
                                                     {Operation::compare_long, 1},
                                                     {Operation::branch_taken, 1}});

/// A chunk is the instructions from one enable_all or enable_load to the next. Processors do not share a chunk.
bool begins_chunk(const isa::Instruction& instruction) {
  return instruction.opcode == isa::Opcode::enable_all || instruction.opcode == isa::Opcode::enable_load;
}

/// Number of chunks; instructions before the first belong to it. At least 1, for the preparation.
std::uint64_t chunks_in(const isa::Segment& segment) {
  const auto chunks = std::ranges::count_if(segment.instructions, begins_chunk);
  return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(chunks));
}

/// Number of chunks of the segment that has the most.
std::uint64_t most_chunks(const isa::Program& program) {
  std::uint64_t chunks = 1;
  for (const isa::Segment& segment : program.segments) chunks = std::max(chunks, chunks_in(segment));
  return chunks;
}

/// `parts` of `all` equal parts of the work, rounded up.
Operations part_of(Operations work, std::uint64_t parts, std::uint64_t all) {
  for (std::uint64_t& count : work.counts) {
    // The product of whole parts fits; that of the remainder too, since there are fewer than 2^32 chunks.
    count = count / all * parts + quotient_up(count % all * parts, all);
  }
  return work;
}

/// What each processor has taken.
class Shares {
 public:
  Shares(std::size_t processors, unsigned link_width)
      : taken_(processors, Taken{.work{}, .writer = Writer(link_width)}) {}

  /// Assigns `parts` equal parts of the work to the processors in turn, beginning with the first processor.
  void divide(const Operations& work, std::uint64_t parts) {
    const std::uint64_t processors = taken_.size();
    for (std::uint64_t i = 0; i < processors; ++i) {
      const std::uint64_t own = parts / processors + (i < parts % processors ? 1 : 0);
      taken_[i].work += part_of(work, own, parts);
    }
  }

  /// Assigns the chunks of a segment to the processors in turn, beginning with the processor after that of the last
  /// chunk. Each chunk takes its part of the segment's preparation with it.
  void divide(const isa::Segment& segment) {
    const std::uint64_t chunks = chunks_in(segment);
    for (Taken& one : taken_) one.writer.begin(segment.region);
    const Operations prepared = part_of(count_operations(*segment.preparation), 1, chunks);
    bool has_begun = false;
    take(prepared);
    for (const isa::Instruction& instruction : segment.instructions) {
      if (begins_chunk(instruction)) {
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

  /// Charges the first processor for merging these longs and chunks of the other processors.
  void merge(std::uint64_t longs, std::uint64_t chunks) {
    taken_.front().work += longs * long_copied;
    taken_.front().work += chunks * chunk_merged;
  }
  void merge() {
    std::uint64_t longs = 0;
    std::uint64_t chunks = 0;
    for (std::size_t i = 1; i < taken_.size(); ++i) {
      longs += taken_[i].writer.written().longs + taken_[i].writer.written().kept_longs;
      chunks += taken_[i].chunks;
    }
    merge(longs, chunks);
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
    std::uint64_t chunks = 0;
  };

  void take(const Operations& prepared) {
    taken_[turn_].work += prepared;
    ++taken_[turn_].chunks;
  }
  void next() { turn_ = (turn_ + 1) % taken_.size(); }

  std::vector<Taken> taken_;
  std::size_t turn_ = 0;
};

}  // namespace

Operations busiest_processor_operations(const isa::Program& program, const machines::Machine& machine,
                                        const processors::Processor& processor) {
  const std::uint64_t processors = machine.kind->host_processor_count(machine);
  Shares shares(processors, machine.link.width);
  const std::uint64_t chunks = most_chunks(program);
  shares.divide(count_operations(*program.preparation), chunks);
  if (machines::division(machine)) {
    const std::uint64_t longs = model_long_count(program);
    shares.divide(longs * model_long_operations(), chunks);
    const std::uint64_t own = quotient_up(chunks, processors);
    shares.merge(longs - std::min(longs, longs * own / chunks), chunks - own);
    return shares.largest(processor);
  }
  for (const isa::Segment& segment : program.segments) shares.divide(segment);
  shares.merge();
  return shares.largest(processor);
}

Operations busiest_processor_model_operations(const isa::Program& program, const machines::Machine& machine) {
  const std::uint64_t chunks = most_chunks(program);
  const std::uint64_t own = quotient_up(chunks, std::uint64_t{machine.kind->host_processor_count(machine)});
  return part_of(count_operations(*program.model_preparation), own, chunks);
}

}  // namespace csgsim::host
