#include "hw/scan_line/timing.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "hw/base/quotient.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/wire.h"
#include "hw/machines/clocks.h"
#include "hw/scan_line/account.h"
#include "hw/scan_line/figures.h"
#include "hw/scan_line/kind.h"

namespace csgsim::scan_line {

namespace {

using machines::Machine;

/// Number of a clock edge, from 1.
using Edge = std::uint64_t;

/// After so many frames alike the distance from one to the next is taken for that of all that follow. With one chain it
/// is from the second on.
constexpr unsigned frames_to_settle = 8;

/// Words of a cell's memory that hold a bit of the field.
std::uint64_t memory_words(isa::Field field, const Figures& figures) {
  if (field.width == 0) return 0;
  const std::uint32_t word = std::max(figures.word_bits, 1U);
  return quotient_up(field.end(), word) - field.base / word;
}

/// Clocks of all trials of a root: each takes two bits of the field more to the remainder, which has one more than the
/// root found so far and a sign.
std::uint64_t trial_clocks(isa::Field field, const Figures& figures) {
  const std::uint32_t word = std::max(figures.word_bits, 1U);
  const std::uint32_t width = figures.alu_bits == 0 ? word : std::min(figures.alu_bits, word);
  std::uint64_t clocks = 0;
  for (std::uint32_t found = 0; 2 * found + 1 < field.width; ++found) clocks += quotient_up(found + 3, width);
  return clocks;
}

/// Clocks of a packet of so many words that reads so many words of memory, works for so many clocks on all of these,
/// and writes so many.
std::uint64_t occupied(std::uint64_t words, std::uint64_t read, std::uint64_t work, std::uint64_t written,
                       const Figures& figures) {
  const std::uint64_t reads = figures.ports == 0 ? 0 : quotient_up(read, figures.ports);
  const std::uint64_t worked = std::max(words, reads) + (work > 0 ? work - 1 : 0);
  if (figures.ports == 0 || written == 0) return worked;
  return std::max(worked, reads + 1) + quotient_up(written, figures.ports) - 1;
}

/// Clocks that the shifter takes for an operand of so many bits, of which the lowest is at that place of its memory, or
/// of F, to come to the place of the field in its words.
std::uint64_t shift_clocks(std::uint64_t from, std::uint64_t bits, isa::Field field, const Figures& figures) {
  if (figures.shift_bits == 0) return 0;
  const std::uint64_t word = std::max(figures.word_bits, 1U);
  const std::uint64_t place = field.base % word;
  const std::uint64_t other = from % word;
  const std::uint64_t distance = std::max(place, other) - std::min(place, other);
  return quotient_up(distance, figures.shift_bits) * quotient_up(place + bits, word);
}

std::uint64_t alu_clocks(std::uint64_t bits, const Figures& figures) {
  if (bits == 0) return 0;
  const std::uint64_t width = std::min(figures.alu_bits, std::max(figures.word_bits, 1U));
  return width == 0 ? 1 : quotient_up(bits, width);
}

/// Clocks of shifter and ALU with the value of a linear expression: it is held against a field, or against the width of
/// one that it is written to; or a field is added to it, from which on its upper bits are of no use.
std::uint64_t linear_work(const isa::Instruction& instruction, const Figures& figures) {
  const isa::Field& field = instruction.fields[0];
  if (field.width == 0) return 0;
  const isa::Linear& linear = instruction.linear;
  const std::uint64_t value = linear.width - std::uint64_t{linear.shift};
  const bool is_sum = isa::info(instruction.opcode).enable_effect == isa::EnableEffect::keeps;
  const std::uint64_t used = is_sum ? std::min<std::uint64_t>(value, field.width) : value;
  return shift_clocks(linear.shift, used, field, figures) + alu_clocks(is_sum ? field.width : value, figures);
}

/// The same with fields alone: the others are moved to the first.
std::uint64_t field_work(const isa::Instruction& instruction, const Figures& figures) {
  const auto& [first, second, third] = instruction.fields;
  std::uint64_t clocks = 0;
  if (second.width > 0) clocks += shift_clocks(second.base, second.width, first, figures);
  if (third.width > 0) clocks += shift_clocks(third.base, third.width, first, figures);
  const bool as_it_is = instruction.opcode == isa::Opcode::copy || instruction.opcode == isa::Opcode::set_constant;
  return clocks + (as_it_is ? 0 : alu_clocks(first.width, figures));
}

std::uint64_t work_clocks(const isa::Instruction& instruction, const Figures& figures) {
  switch (isa::info(instruction.opcode).clock_class) {
    case isa::ClockClass::one:
    case isa::ClockClass::answer: return 0;
    case isa::ClockClass::linear_once:
    case isa::ClockClass::linear_twice: return linear_work(instruction, figures);
    case isa::ClockClass::field:
    case isa::ClockClass::two_fields: return field_work(instruction, figures);
    case isa::ClockClass::root: return trial_clocks(instruction.fields[0], figures);
  }
  return 0;
}

/// How many primitives the host looks at for each line.
std::vector<std::uint64_t> active_looks(const isa::Program& program) {
  // By row: primitives that begin at it or above, and that end above it.
  std::vector<std::uint64_t> begun(program.shape.height + 1);
  std::vector<std::uint64_t> ended(program.shape.height + 1);
  for (const isa::RowExtent& extent : program.extents) {
    ++begun[extent.first];
    ++ended[extent.last + 1U];
  }
  for (std::size_t row = 1; row < begun.size(); ++row) {
    begun[row] += begun[row - 1];
    ended[row] += ended[row - 1];
  }
  std::vector<std::uint64_t> looks;
  std::optional<std::uint32_t> before;
  for (const isa::Segment& line : program.segments) {
    const std::uint32_t row = line.region.y;
    if (before && *before > row) before.reset();  // a field begins
    looks.push_back(begun[row] - (before ? ended[*before] : 0));
    before = row;
  }
  return looks;
}

/// Clocks from the entry until a beat is in the last cell of a line: a chain's cells one after the other, or as many
/// levels as all cells have bits in their numbers.
std::uint64_t last_cell(const Machine& machine, std::uint32_t pixels) {
  if (machines::own<Figures>(machine).network == Network::chain) return pixels - 1;
  return static_cast<std::uint64_t>(std::bit_width(machine.array.width - 1));
}

/// What a command takes.
struct Cost {
  std::uint64_t words = 0;  ///< on the link
  std::uint64_t beats = 0;  ///< of its packet; 0 if it is none
};

/// Of each instruction, in the order of the Program.
std::vector<Cost> costs_of(const isa::Program& program, const Machine& machine) {
  std::vector<Cost> costs;
  for (const isa::Segment& line : program.segments)
    for (const isa::Instruction& instruction : line.instructions)
      costs.push_back({isa::wire_words(instruction, machine.link.width), machines::clocks(instruction, machine)});
  return costs;
}

/// A link and the entry of its chain, as the lines that they have been given leave them.
class ChainTiming {
 public:
  /// No mark enters before edge `first_mark`.
  ChainTiming(const Machine& machine, isa::ArrayShape picture, isa::Field colour, Edge first_mark)
      : machine_(machine),
        figures_(machines::own<Figures>(machine)),
        pixels_(picture.width),
        through_cells_(last_cell(machine, picture.width) + 1ULL),
        budget_(line_budget(machine, picture.height)),
        colour_(colour),
        mark_from_(first_mark) {}

  /// The host can hand over the next line from that edge on.
  [[nodiscard]] Edge free_from() const { return lines_ == 0 ? 1 : taken_ + 1; }

  /// `costs`: of the line's instructions. Tells, if there is a timeline, when the packets of line `number` enter.
  void draw(const isa::Segment& line, std::span<const Cost> costs, Edge handed_over, machines::Timeline* told,
            std::size_t number) {
    const Edge idle_from = lines_ == 0 ? 1 : sent_;
    taken_ = std::max(handed_over + 1, idle_from);
    link_.add(LineActivity::waiting_for_host, taken_ - idle_from);
    const Edge latency = lines_ == 0 ? machine_.link.latency : 0;
    link_.add(LineActivity::latency, latency);
    sent_ = taken_ + latency;
    send({words_of(isa::SegmentStart{line.region}), machine_.clear_clocks});
    if (told != nullptr && machine_.clear_clocks > 0) told->cleared[number] = entering(machine_.clear_clocks);
    for (std::size_t i = 0; i < costs.size(); ++i) {
      send(costs[i]);
      if (told != nullptr) told->issued[number][i] = entering(costs[i].beats);
    }
    const bool empty = costs.empty();
    const std::uint64_t colour_words = std::max<std::uint64_t>(quotient_up(colour_.width, figures_.word_bits), 1);
    const std::uint64_t mark = empty ? colour_words : occupied(1, memory_words(colour_, figures_), 0, 0, figures_);
    send({words_of(isa::SegmentEnd{}), mark}, true);
    if (told != nullptr && machine_.clear_clocks == 0)
      told->cleared[number] = first_beat(empty ? entering(mark) : told->issued[number].front());
    ++lines_;
  }

  [[nodiscard]] std::uint64_t lines() const { return lines_; }
  [[nodiscard]] std::uint64_t words() const { return words_; }
  [[nodiscard]] std::uint64_t late_lines() const { return late_lines_; }
  [[nodiscard]] Edge mark() const { return mark_; }  ///< its last beat is at the entry
  /// From then on through the cells, and through the shift chain.
  [[nodiscard]] std::uint64_t drain() const { return through_cells_ + pixels_; }
  /// From then on the next mark may enter.
  [[nodiscard]] Edge mark_from() const { return mark_from_; }
  [[nodiscard]] Edge first_packet() const { return first_packet_; }  ///< likewise
  [[nodiscard]] const LineClocks& entry() const { return entry_; }

  /// Of a frame of so many clocks, until now.
  [[nodiscard]] LineClocks whole_link(std::uint64_t clocks) const {
    LineClocks whole = link_;
    whole.add(LineActivity::done, clocks + 1 - (lines_ == 0 ? 1 : sent_));
    return whole;
  }
  [[nodiscard]] LineClocks whole_entry(std::uint64_t clocks) const {
    LineClocks whole = entry_;
    whole.add(LineActivity::done, clocks - mark_);
    return whole;
  }
  [[nodiscard]] LineClocks whole_refresh(std::uint64_t clocks) const {
    LineClocks whole;
    const std::uint64_t shown = lines_ * pixels_;
    const std::uint64_t end = lines_ == 0 ? 0 : mark_ + drain();
    whole.add(LineActivity::showing, shown);
    whole.add(LineActivity::waiting_for_line, end - shown);
    whole.add(LineActivity::done, clocks - end);
    return whole;
  }

 private:
  /// The clocks in which the beats of the last packet, so many, were at the entry: it is there from edge n until the
  /// next in clock n - 1.
  [[nodiscard]] machines::ClockSpan entering(std::uint64_t beats) const { return {entered_ - beats, entered_}; }

  /// Where no packet clears, the line's first does.
  static machines::ClockSpan first_beat(const machines::ClockSpan& packet) { return {packet.begin, packet.begin + 1}; }

  [[nodiscard]] std::uint64_t words_of(const isa::Command& command) const {
    return isa::wire_words(command, machine_.link.width);
  }

  /// A command and its packet.
  void send(const Cost& cost, bool is_mark = false) {
    const auto& [words, beats] = cost;
    for (std::uint64_t word = 0; word < words; ++word) {
      const Edge stored = store();
      read_ = std::max({stored + 1, read_ + 1, word == 0 ? taken_by_entry_ : 0});
      if (reads_.size() == machine_.link.fifo_depth) reads_.pop_front();
      reads_.push_back(read_);
    }
    taken_by_entry_ = std::max(read_, entered_) + 1;
    if (beats == 0) return;
    entry_.add(LineActivity::waiting_for_link, taken_by_entry_ - entered_ - 1);
    entry_.add(LineActivity::entering, beats);
    const Edge asked = taken_by_entry_ + beats - 1;
    entered_ = is_mark ? std::max(asked, mark_from_) : asked;
    entry_.add(LineActivity::waiting_for_refresh, entered_ - asked);
    if (first_packet_ == 0) first_packet_ = entered_;
    if (is_mark) end_line();
  }

  /// The edge at which the next word goes into the FIFO.
  Edge store() {
    const Edge asked = sent_ + machine_.link.word_clocks;
    const Edge room = reads_.size() < machine_.link.fifo_depth ? 0 : reads_.front() + 1;
    sent_ = std::max(asked, room);
    link_.add(LineActivity::sending, machine_.link.word_clocks);
    link_.add(LineActivity::waiting_for_entry, sent_ - asked);
    ++words_;
    return sent_;
  }

  void end_line() {
    if (entered_ - mark_ > budget_) ++late_lines_;
    mark_ = entered_;
    mark_from_ = mark_ + mark_spacing(pixels_);
  }

  const Machine& machine_;
  const Figures& figures_;
  std::uint32_t pixels_;
  std::uint64_t through_cells_;  ///< clocks in which a beat comes to, and is in, the line's last cell
  std::uint64_t budget_;
  isa::Field colour_;

  Edge taken_ = 0;           ///< the link has taken the last line from the host
  Edge sent_ = 0;            ///< the last word has gone into the FIFO
  Edge read_ = 0;            ///< it has been read
  std::deque<Edge> reads_;   ///< of the last words, as many as the FIFO is deep
  Edge taken_by_entry_ = 0;  ///< the last command
  Edge entered_ = 0;         ///< the last packet's last beat
  Edge mark_ = 0;            ///< that of the last mark
  Edge mark_from_ = 0;       ///< that of the next, at the earliest
  Edge first_packet_ = 0;    ///< that of the frame's first
  std::uint64_t lines_ = 0;
  std::uint64_t words_ = 0;
  std::uint64_t late_lines_ = 0;
  LineClocks link_;
  LineClocks entry_;
};

/// For each chain, the edge, counted from the frame's beginning, from which its next mark may enter.
using MarkEdges = std::vector<Edge>;

/// The frame before has left `marks` behind, which become those that this one leaves.
LineTiming time_frame(const isa::Program& program, const Machine& machine, std::span<const Cost> costs,
                      MarkEdges& marks, machines::Timeline* told = nullptr) {
  const Figures& figures = machines::own<Figures>(machine);
  const std::uint64_t pixels = program.shape.width;
  const isa::Field colour = isa::frame_header(program).colour;
  LineAccount counted{.lines = program.segments.size(), .line_budget = line_budget(machine, program.shape.height)};
  std::vector<ChainTiming> chains;
  for (const Edge mark : marks) chains.emplace_back(machine, program.shape, colour, mark);

  const std::vector<std::uint64_t> looks = active_looks(program);
  const std::uint64_t sorting = program.extents.size() * figures.bucket_clocks;
  counted.host.add(LineActivity::sorting, sorting);
  Edge host = sorting;  // the last edge at which it has worked
  for (std::size_t line = 0; line < program.segments.size(); ++line) {
    const isa::Segment& segment = program.segments[line];
    ChainTiming& chain = chains[line % chains.size()];
    const std::uint64_t updating = looks[line] * figures.active_clocks;
    const std::uint64_t preparing = segment.instructions.size() * figures.instruction_clocks;
    const Edge asked = host + updating + preparing + 1;
    host = std::max(asked, chain.free_from());
    counted.host.add(LineActivity::updating, updating);
    counted.host.add(LineActivity::preparing, preparing);
    counted.host.add(LineActivity::waiting_for_link, host - asked);
    counted.host.add(LineActivity::starting, 1);
    const std::span<const Cost> of_line = costs.first(segment.instructions.size());
    costs = costs.subspan(of_line.size());
    chain.draw(segment, of_line, host, told, line);

    counted.packets += segment.instructions.size();
    counted.most_packets = std::max<std::uint64_t>(counted.most_packets, segment.instructions.size());
    for (const Cost& cost : of_line) counted.busy_cells += cost.beats * pixels;
  }

  const auto latest = std::max_element(chains.begin(), chains.end(),
                                       [](const auto& one, const auto& other) { return one.mark() < other.mark(); });
  counted.drain_clocks = latest->drain();
  const std::uint64_t clocks = latest->mark() + counted.drain_clocks;
  counted.host.add(LineActivity::done, clocks - host);
  counted.link = latest->whole_link(clocks);
  counted.entry = latest->whole_entry(clocks);
  counted.refresh = latest->whole_refresh(clocks);
  const Edge interval = latest->mark();
  for (std::size_t i = 0; i < chains.size(); ++i)
    marks[i] = chains[i].mark_from() - std::min(chains[i].mark_from(), interval);
  for (const ChainTiming& chain : chains) {
    counted.link_words += chain.words();
    counted.late_lines += chain.late_lines();
    counted.entry_clocks += chain.entry().of(LineActivity::entering);
    counted.refresh_clocks += chain.entry().of(LineActivity::waiting_for_refresh);
    if (chain.lines() == 0) continue;
    const std::uint64_t fill = chain.first_packet() + last_cell(machine, program.shape.width);
    counted.fill_clocks = counted.fill_clocks == 0 ? fill : std::min(counted.fill_clocks, fill);
  }
  return {clocks, interval, counted};
}

}  // namespace

std::uint64_t packet_words(const isa::Instruction& instruction, const Machine& machine) {
  const std::uint64_t word = std::max(machines::own<Figures>(machine).word_bits, 1U);
  if (instruction.opcode == isa::Opcode::squares) return 1;
  const Figures& figures = machines::own<Figures>(machine);
  const std::uint64_t brought =
      figures.network == Network::trees ? std::min<std::uint64_t>(figures.tree_bits, word) : word;
  return std::max<std::uint64_t>(
      {quotient_up(instruction.linear.width, brought), quotient_up(machines::field_width(instruction), word), 1});
}

std::uint64_t Kind::clocks(const isa::Instruction& instruction, const Machine& machine) const {
  const Figures& figures = machines::own<Figures>(machine);
  const isa::OpcodeInfo& row = isa::info(instruction.opcode);
  const bool changes = isa::reads_target(instruction.opcode);
  std::uint64_t read = 0;
  std::uint64_t written = 0;
  for (std::size_t i = 0; i < isa::max_operands; ++i) {
    const std::uint64_t words = memory_words(instruction.fields.at(i), figures);
    if (row.operands.at(i) == isa::OperandKind::target) written += words;
    if (row.operands.at(i) == isa::OperandKind::source || changes) read += words;
  }
  const std::uint64_t work = work_clocks(instruction, figures);
  if (instruction.opcode != isa::Opcode::root)
    return occupied(packet_words(instruction, machine), read, work, written, figures);
  const std::uint64_t reads = figures.ports == 0 ? 0 : quotient_up(read, figures.ports);
  return occupied(reads + work, read, 0, written, figures);
}

std::uint64_t line_budget(const Machine& machine, std::uint32_t picture_height) {
  const Figures& figures = machines::own<Figures>(machine);
  const std::uint64_t field_lines = figures.interlaced ? (picture_height + 1ULL) / 2 : picture_height;
  return figures.chains * (machine.clock_hz / (figures.refresh_hz * field_lines));
}

LineTiming time_lines(const isa::Program& program, const Machine& machine, machines::Timeline* told) {
  MarkEdges marks(machines::own<Figures>(machine).chains);
  const std::vector<Cost> costs = costs_of(program, machine);
  LineTiming alone = time_frame(program, machine, costs, marks, told);
  for (unsigned frame = 0; frame < frames_to_settle; ++frame) {
    const MarkEdges before = marks;
    alone.interval_clocks = time_frame(program, machine, costs, marks).interval_clocks;
    if (marks == before) break;
  }
  return alone;
}

std::vector<LineTiming> time_line_sequence(std::span<const isa::Program> frames, const Machine& machine) {
  MarkEdges marks(machines::own<Figures>(machine).chains);
  std::vector<LineTiming> timings;
  for (const isa::Program& frame : frames)
    timings.push_back(time_frame(frame, machine, costs_of(frame, machine), marks));
  return timings;
}

machines::FrameTiming Kind::time(const isa::Program& program, const Machine& machine,
                                 const machines::Told& /*told*/) const {
  const LineTiming timing = time_lines(program, machine);
  return {.clocks = timing.clocks,
          .shown_clocks = timing.clocks,
          .interval_clocks = timing.interval_clocks,
          .account = account(timing.account, machine, timing.clocks)};
}

std::optional<machines::Timeline> Kind::timeline(const isa::Program& program, const Machine& machine,
                                                 const machines::Told& /*told*/) const {
  machines::Timeline told = machines::blank_timeline(program);
  time_lines(program, machine, &told);
  return told;
}

std::vector<machines::ClockSpan> Kind::at_pixel(const machines::Timeline& timeline, const isa::Program& program,
                                                const Machine& machine, std::uint32_t segment, std::uint32_t x,
                                                std::uint32_t /*y*/) const {
  const std::uint32_t cell = x - program.segments[segment].region.x;
  return machines::later(timeline.issued[segment],
                         clocks_to_cell(figures_of(machine).network, machine.array.width, cell));
}

}  // namespace csgsim::scan_line
