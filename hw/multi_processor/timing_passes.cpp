#include "hw/multi_processor/timing_passes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/quotient.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/link_word.h"
#include "hw/isa/wire.h"
#include "hw/multi_processor/clocks.h"
#include "hw/multi_processor/figures.h"

namespace csgsim::multi_processor {

namespace {

using machines::Machine;

/// The part of its list that a node builds before its memory is full.
struct BuiltPart {
  std::size_t commands = 0;
  std::uint64_t words = 0;   ///< words in the node's memory
  std::uint64_t clocks = 0;  ///< clocks to build the part
  std::uint64_t reads = 0;   ///< half-spaces read from the display processor
};

/// Maximum number of a node's words that a command takes.
std::uint64_t max_command_words(const Machine& machine) {
  return quotient_up(isa::LinkWord::max_bits, machines::kind_figures<Figures>(machine).word_bits);
}

/// Words of a command of a list: its start, the instructions, its end.
std::uint64_t command_words(const isa::Segment& part, std::size_t command, const ListForm& form,
                            std::uint32_t word_bits) {
  if (command == 0) return quotient_up(isa::wire_bits(isa::SegmentStart{}), word_bits);
  if (command <= part.instructions.size())
    return quotient_up(written_bits(part.instructions[command - 1], form), std::uint64_t{word_bits});
  return quotient_up(isa::wire_bits(isa::SegmentEnd{}), word_bits);
}

std::size_t count_commands(const isa::Segment& part) { return part.instructions.size() + 2; }

std::uint64_t test_clocks(const isa::DivisionStep& step, const TestClocks& each) {
  return step.boxes * each.primitive + step.halfspaces * each.halfspace + step.cells * each.cell +
         step.nodes * each.tree_node;
}

/// Divides a list into parts of at most `room` words. Tests precede the instructions that they lead to.
class ListBuilder {
 public:
  /// `read`: clocks to read a half-space over the bus; 0 if half-spaces are in the node's memory.
  ListBuilder(const isa::Segment& part, std::uint64_t room, std::uint64_t read, const ListForm& form,
              const TestClocks& each, const Figures& figures)
      : part_(part), room_(room), read_(read), form_(form), each_(each), figures_(figures) {}

  std::vector<BuiltPart> build() {
    put(0);
    for (const isa::DivisionStep& step : part_.division->steps) {
      now_.clocks += test_clocks(step, each_) + step.halfspaces * read_;
      if (read_ > 0) now_.reads += step.halfspaces;
      for (std::uint64_t i = 0; i < step.instructions && next_ <= part_.instructions.size(); ++i) put_instruction();
    }
    while (next_ <= part_.instructions.size()) put_instruction();
    put(0);
    all_.push_back(now_);
    return all_;
  }

 private:
  void put_instruction() {
    put(uses_index(part_.instructions[next_ - 1], form_) ? figures_.number_clocks : each_.instruction);
  }

  void put(std::uint64_t clocks) {
    const std::uint64_t words = command_words(part_, next_++, form_, figures_.word_bits);
    if (now_.words + words > room_) all_.push_back(std::exchange(now_, {}));
    ++now_.commands;
    now_.words += words;
    now_.clocks += clocks;
  }

  const isa::Segment& part_;
  const std::uint64_t room_;
  const std::uint64_t read_;
  const ListForm form_;
  const TestClocks each_;
  const Figures& figures_;
  std::size_t next_ = 0;
  BuiltPart now_;
  std::vector<BuiltPart> all_;
};

/// Simulates the sending of the lists, node after node.
class ListExchange {
 public:
  ListExchange(Subsegments parts, const ListRoom& room, std::uint64_t read, const ListForm& form,
               const TestClocks& each, const Machine& machine)
      : parts_(parts),
        form_(form),
        room_(room.words),
        is_remote_(room.is_remote),
        is_alone_(machine.array.width * machine.array.height == 1),
        max_command_words_(max_command_words(machine)),
        node_bits_(machines::kind_figures<Figures>(machine).word_bits),
        bus_bits_(machine.link.width) {
    const std::uint64_t own_room = parts.size() == 1 || is_remote_ ? room_ : room_ / 2;
    for (const isa::Segment& part : parts)
      built_.push_back(
          ListBuilder(part, own_room, is_remote_ ? read : 0, form, each, machines::kind_figures<Figures>(machine))
              .build());
  }

  Passes run() {
    passes_.is_remote = is_remote_;
    passes_.form = form_;
    for (const std::vector<BuiltPart>& list : built_) passes_.divided.push_back(is_remote_ ? 0 : list.front().clocks);
    for (std::size_t node = 0; node < parts_.size(); ++node) send_list(node);
    return passes_;
  }

 private:
  /// Whether another node has no room for one more command. The first parts of the lists still to be sent are in
  /// memory.
  [[nodiscard]] bool is_full() const { return !is_alone_ && room_ - waiting_ - received_ < max_command_words_; }

  void send_list(std::size_t node) {
    waiting_ = 0;
    for (std::size_t other = node + 1; other < built_.size() && !is_remote_; ++other)
      waiting_ = std::max(waiting_, built_[other].front().words);
    std::size_t command = 0;
    for (std::size_t i = 0; i < built_[node].size(); ++i) {
      const BuiltPart& part_built = built_[node][i];
      if (i > 0 || is_remote_) {
        begin(node, part_built.clocks, part_built.reads);
      } else {
        begin(node);
      }
      for (const std::size_t end = command + part_built.commands; command < end; ++command) {
        if (is_full()) {
          pause();
          begin(node);
        }
        send(command);
      }
      if (i + 1 < built_[node].size()) pause();
    }
    if (is_remote_) {
      stop();
    } else {
      passes_.messages.push_back(std::exchange(now_, {}));
    }
  }

  void begin(std::size_t node, std::uint64_t divided = 0, std::uint64_t reads = 0) {
    now_ = {.node = node, .divided = divided, .reads = reads, .words = 0, .piece = {}, .pauses = false};
  }

  void send(std::size_t command) {
    const isa::Segment& part = parts_[now_.node];
    if (!now_.piece) now_.piece = Piece{.subsegment = now_.node, .first = command == 0 ? 0 : command - 1};
    now_.words += command_words(part, command, form_, bus_bits_);
    received_ += command_words(part, command, form_, node_bits_);
    if (command > 0 && command <= part.instructions.size()) ++now_.piece->count;
    if (command + 1 == count_commands(part)) now_.piece->ends = true;
  }

  /// A pause word ends the message.
  void pause() {
    ++now_.words;
    stop();
  }

  /// Ends the message with a pause, in which the parts received are rendered and leave the memory.
  void stop() {
    now_.pauses = true;
    passes_.messages.push_back(std::exchange(now_, {}));
    received_ = 0;
  }

  const Subsegments parts_;
  const ListForm form_;
  const std::uint64_t room_;
  const bool is_remote_;
  const bool is_alone_;
  const std::uint64_t max_command_words_;
  const std::uint32_t node_bits_;
  const std::uint32_t bus_bits_;
  std::vector<std::vector<BuiltPart>> built_;
  std::uint64_t received_ = 0;  ///< memory words of the lists received since the last pause
  std::uint64_t waiting_ = 0;   ///< words of the own list of the fullest node
  Message now_;
  Passes passes_;
};

}  // namespace

ListRoom list_room(Subsegments parts, const ModelSizes& sizes, const Machine& machine) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  const SegmentDivision division = segment_division(parts);
  const std::uint64_t reserved = 2 * max_command_words(machine);
  std::uint64_t records = 0;
  for (const std::uint64_t halfspaces : {division.halfspaces, std::uint64_t{0}}) {
    records = frame_words(sizes, figures.word_bits) +
              segment_words(sizes, division.primitives, halfspaces, figures.word_bits);
    if (records + reserved <= figures.memory_words)
      return {figures.memory_words - records, halfspaces < division.halfspaces};
  }
  throw InputError(fmt::format(
      "the segment at {},{} needs {} words of a node at once, but the nodes of {} have {}; increase node.memory_words "
      "or subdivision.levels in the machine file",
      parts.front().region.x, parts.front().region.y, records + reserved, machine.name, figures.memory_words));
}

ListForm list_form(Subsegments parts, bool is_remote, const ModelSizes& sizes, const Machine& machine) {
  if (is_remote) return {};
  ListForm form = longest_form(sizes, machine);
  const std::uint64_t halfspaces = segment_division(parts).halfspaces;
  form.number_bits = 1;
  while (halfspaces > 0 && (halfspaces - 1) >> form.number_bits > 0) ++form.number_bits;
  return form;
}

ListForm longest_form(const ModelSizes& sizes, const Machine& machine) {
  const auto bits = [](std::uint32_t width) { return static_cast<std::uint8_t>(width); };
  if (machines::kind_figures<Figures>(machine).lists == ListKind::instructions) return {};
  return {.has_numbers = true,
          .number_bits = 64,
          .record_bits = static_cast<unsigned>(halfspace_bits(sizes)),
          .record_numbers = {1, 1, bits(sizes.slope), bits(sizes.slope), bits(sizes.constant)}};
}

ReadClocks read_clocks(const ModelSizes& sizes, const Machine& machine) {
  const machines::Link& bus = machine.link;
  ReadClocks read{.request_words = quotient_up(request_bits(sizes), bus.width),
                  .answer_words = quotient_up(halfspace_bits(sizes), bus.width)};
  read.request = bus.latency + read.request_words * bus.word_clocks;
  read.answer = bus.latency + read.answer_words * bus.word_clocks;
  return read;
}

Passes plan_passes(Subsegments parts, const ModelSizes& sizes, const Machine& machine) {
  const TestClocks each = node_test_clocks(sizes, machines::kind_figures<Figures>(machine));
  const ListRoom room = list_room(parts, sizes, machine);
  const ListForm form = list_form(parts, room.is_remote, sizes, machine);
  return ListExchange(parts, room, read_clocks(sizes, machine).clocks(), form, each, machine).run();
}

}  // namespace csgsim::multi_processor
