// Processor operations per task of the host.
// Used by hw/host, sim/session and tests.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <unordered_set>

#include "hw/isa/host_counts.h"
#include "hw/isa/program.h"
#include "hw/processors/operations.h"

// Operations of a host's processor for a frame (docs/host.md). The frequency of each task is counted; the operations
// per task are assumed, as a careful programmer would write them for longs of 32 bits.
namespace csgsim::host {

/// A task of the host, with the operations of one execution.
struct Recipe {
  std::string_view name;  ///< name in Programs
  std::uint64_t isa::Preparation::*count;
  processors::Operations each;
};

std::span<const Recipe> recipes();

/// Operations of the task with that name, which must exist.
processors::Operations recipe(std::string_view task_name);

/// Operations of all counted tasks.
processors::Operations count_operations(const isa::Preparation& preparation);

/// Counts of the written instructions that determine the work of writing them.
struct Written {
  std::uint64_t instructions = 0;
  std::uint64_t kept = 0;        ///< part of `instructions` whose words the host has kept and only copies
  std::uint64_t kept_longs = 0;  ///< longs of kept words that are copied
  std::uint64_t numbers = 0;     ///< numbers after the opcodes of the other instructions
  std::uint64_t longs = 0;       ///< longs stored for their words
  std::uint64_t linear = 0;      ///< linear expressions, each once per segment
  /// Linear expressions of segments that do not begin at the picture's corner. Expressions that also occur in the
  /// segment above are not counted, because one addition moves them.
  std::uint64_t moved = 0;
  std::uint64_t squares = 0;  ///< squares, each once per segment

  bool operator==(const Written&) const = default;
};

/// Counts the work of a host that writes instructions and keeps some of their words for reuse. It keeps the words of
/// instructions with an expression until the end of the segment, because each plane is broadcast several times, and the
/// words of instructions without an expression until the end of the frame.
class Writer {
 public:
  explicit Writer(unsigned link_width) : link_width_(link_width) {}

  /// Begins the next segment.
  void begin(const isa::Region& region);
  void add(const isa::Instruction& instruction);

  [[nodiscard]] const Written& written() const { return written_; }

 private:
  unsigned link_width_;
  bool is_moved_ = false;
  isa::Region region_{};
  std::unordered_set<std::uint64_t> expressions_;  ///< hashes of the segment's expressions
  std::unordered_set<std::uint64_t> above_;  ///< hashes of the previous segment's expressions, if it is the row above
  std::unordered_set<std::uint64_t> words_;  ///< hashes of the segment's instructions with an expression
  std::unordered_set<std::uint64_t> frame_words_;  ///< hashes of the frame's other instructions
  Written written_;
};

/// Operations to move expressions to their segments, minimize their widths, and assemble and store the instructions.
processors::Operations count_operations(const Written& written);

/// Operations to move a linear expression to a region's corner and to find its common trailing zeros and its width.
processors::Operations expression_fitting_operations();

/// Operations to store a long of an assembled command.
processors::Operations long_store_operations();

/// Number of longs (32 bits) of the display model.
std::uint64_t model_long_count(const isa::Program& program);

/// Operations for one long of the display model, assembled from its numbers.
processors::Operations model_long_operations();

}  // namespace csgsim::host
