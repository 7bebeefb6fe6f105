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

/// Number of a clock edge, counted from 1.
using Edge = std::uint64_t;

/// Number of identical frames after which the interval between frames is assumed to be constant. With one chain it is
/// constant from the second frame on.
constexpr unsigned frames_to_settle = 8;

/// Number of memory words of a cell that contain a bit of the field.
std::uint64_t memory_words(isa::Field field, const Figures& figures) {
  if (field.width == 0) return 0;
  const std::uint32_t word = std::max(figures.word_bits, 1U);
  return quotient_up(field.end(), word) - field.base / word;
}

/// Clocks of all trials of a root: each trial shifts two bits of the field into the remainder, which has one bit more
/// than the partial root, and a sign bit.
std::uint64_t trial_clocks(isa::Field field, const Figures& figures) {
  const std::uint32_t word = std::max(figures.word_bits, 1U);
  const std::uint32_t width = figures.alu_bits == 0 ? word : std::min(figures.alu_bits, word);
  std::uint64_t clocks = 0;
  for (std::uint32_t found = 0; 2 * found + 1 < field.width; ++found) clocks += quotient_up(found + 3, width);
  return clocks;
}

/// Clocks of a packet of `words` words that reads `read` words of memory, processes them for `work` clocks, and writes
/// `written` words.
std::uint64_t occupied_clocks(std::uint64_t words, std::uint64_t read, std::uint64_t work, std::uint64_t written,
                              const Figures& figures) {
  const std::uint64_t reads = figures.ports == 0 ? 0 : quotient_up(read, figures.ports);
  const std::uint64_t work_end = std::max(words, reads) + (work > 0 ? work - 1 : 0);
  if (figures.ports == 0 || written == 0) return work_end;
  return std::max(work_end, reads + 1) + quotient_up(written, figures.ports) - 1;
}

/// Clocks to align an operand of `bits` bits, which starts at bit `from` of memory or of F, with the field's position
/// in its words.
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

/// Clocks of shifter and ALU for the value of a linear expression. The value is compared with a field, or with the
/// width of the field to which it is written; or a field is added to it, and only bits within the field's width are
/// used.
std::uint64_t linear_work(const isa::Instruction& instruction, const Figures& figures) {
  const isa::Field& field = instruction.fields[0];
  if (field.width == 0) return 0;
  const isa::Linear& linear = instruction.linear;
  const std::uint64_t value = linear.width - std::uint64_t{linear.shift};
  const bool is_sum = isa::info(instruction.opcode).enable_effect == isa::EnableEffect::keeps;
  const std::uint64_t used = is_sum ? std::min<std::uint64_t>(value, field.width) : value;
  return shift_clocks(linear.shift, used, field, figures) + alu_clocks(is_sum ? field.width : value, figures);
}

/// Clocks of shifter and ALU for an instruction with fields only: the other fields are aligned with the first.
std::uint64_t field_work(const isa::Instruction& instruction, const Figures& figures) {
  const auto& [first, second, third] = instruction.fields;
  std::uint64_t clocks = 0;
  if (second.width > 0) clocks += shift_clocks(second.base, second.width, first, figures);
  if (third.width > 0) clocks += shift_clocks(third.base, third.width, first, figures);
  const bool bypasses_alu = instruction.opcode == isa::Opcode::copy || instruction.opcode == isa::Opcode::set_constant;
  return clocks + (bypasses_alu ? 0 : alu_clocks(first.width, figures));
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

/// Number of primitives that the host visits for each line.
std::vector<std::uint64_t> active_visits(const isa::Program& program) {
  // Per row: number of primitives that begin in it or above it, and number of primitives that end above it.
  std::vector<std::uint64_t> started(program.shape.height + 1);
  std::vector<std::uint64_t> ended(program.shape.height + 1);
  for (const isa::RowExtent& extent : program.extents) {
    ++started[extent.first];
    ++ended[extent.last + 1U];
  }
  for (std::size_t row = 1; row < started.size(); ++row) {
    started[row] += started[row - 1];
    ended[row] += ended[row - 1];
  }
  std::vector<std::uint64_t> visits;
  std::optional<std::uint32_t> before;
  for (const isa::Segment& line : program.segments) {
    const std::uint32_t row = line.region.y;
    if (before && *before > row) before.reset();  // a new field begins
    visits.push_back(started[row] - (before ? ended[*before] : 0));
    before = row;
  }
  return visits;
}

/// Clocks from the entry until a beat is in the last cell of a line: one per cell of a chain, or one per level of the
/// tree.
std::uint64_t last_cell(const Machine& machine, std::uint32_t pixels) {
  if (machines::kind_figures<Figures>(machine).network == Network::chain) return pixels - 1;
  return static_cast<std::uint64_t>(std::bit_width(machine.array.width - 1));
}

/// Link words and packet beats of a command.
struct Cost {
  std::uint64_t words = 0;  ///< words on the link
  std::uint64_t beats = 0;  ///< beats of its packet; 0 if it has none
};

/// Costs of each instruction, in program order.
std::vector<Cost> costs_of(const isa::Program& program, const Machine& machine) {
  std::vector<Cost> costs;
  for (const isa::Segment& line : program.segments)
    for (const isa::Instruction& instruction : line.instructions)
      costs.push_back({isa::wire_words(instruction, machine.link.width), machines::clocks(instruction, machine)});
  return costs;
}

/// Edge-level model of a link and of the entry of its chain.
class ChainTiming {
 public:
  /// `first_mark`: first edge at which a mark may enter.
  ChainTiming(const Machine& machine, isa::ArrayShape picture, isa::Field colour, Edge first_mark)
      : machine_(machine),
        figures_(machines::kind_figures<Figures>(machine)),
        pixels_(picture.width),
        through_cells_(last_cell(machine, picture.width) + 1ULL),
        budget_(line_budget(machine, picture.height)),
        colour_(colour),
        mark_from_(first_mark) {}

  /// Edge from which the host can transfer the next line.
  [[nodiscard]] Edge free_from() const { return lines_ == 0 ? 1 : taken_ + 1; }

  /// `costs`: costs of the line's instructions. `handed_over`: edge at which the host transfers the line. Records the
  /// packets of line `number` in `timeline`, unless that is null.
  void draw(const isa::Segment& line, std::span<const Cost> costs, Edge handed_over, machines::Timeline* timeline,
            std::size_t number) {
    const Edge idle_from = lines_ == 0 ? 1 : sent_;
    taken_ = std::max(handed_over + 1, idle_from);
    link_.add(LineActivity::waiting_for_host, taken_ - idle_from);
    const Edge latency = lines_ == 0 ? machine_.link.latency : 0;
    link_.add(LineActivity::latency, latency);
    sent_ = taken_ + latency;
    send({words_of(isa::SegmentStart{line.region}), machine_.clear_clocks});
    if (timeline != nullptr && machine_.clear_clocks > 0) timeline->cleared[number] = entering(machine_.clear_clocks);
    for (std::size_t i = 0; i < costs.size(); ++i) {
      send(costs[i]);
      if (timeline != nullptr) timeline->issued[number][i] = entering(costs[i].beats);
    }
    const bool empty = costs.empty();
    const std::uint64_t colour_words = std::max<std::uint64_t>(quotient_up(colour_.width, figures_.word_bits), 1);
    const std::uint64_t mark =
        empty ? colour_words : occupied_clocks(1, memory_words(colour_, figures_), 0, 0, figures_);
    send({words_of(isa::SegmentEnd{}), mark}, true);
    if (timeline != nullptr && machine_.clear_clocks == 0)
      timeline->cleared[number] = first_beat(empty ? entering(mark) : timeline->issued[number].front());
    ++lines_;
  }

  [[nodiscard]] std::uint64_t lines() const { return lines_; }
  [[nodiscard]] std::uint64_t words() const { return words_; }
  [[nodiscard]] std::uint64_t late_lines() const { return late_lines_; }
  [[nodiscard]] Edge mark() const { return mark_; }  ///< edge at which the last beat of the mark is at the entry
  /// Clocks from mark() until the last colour has passed the cells and the shift chain.
  [[nodiscard]] std::uint64_t drain() const { return through_cells_ + pixels_; }
  /// Edge from which the next mark may enter.
  [[nodiscard]] Edge mark_from() const { return mark_from_; }
  /// Edge at which the last beat of the first packet entered.
  [[nodiscard]] Edge first_packet() const { return first_packet_; }
  [[nodiscard]] const LineClocks& entry() const { return entry_; }

  /// Clocks of the link in a frame of `clocks` clocks.
  [[nodiscard]] LineClocks link_clocks(std::uint64_t clocks) const {
    LineClocks whole = link_;
    whole.add(LineActivity::done, clocks + 1 - (lines_ == 0 ? 1 : sent_));
    return whole;
  }
  [[nodiscard]] LineClocks entry_clocks(std::uint64_t clocks) const {
    LineClocks whole = entry_;
    whole.add(LineActivity::done, clocks - mark_);
    return whole;
  }
  [[nodiscard]] LineClocks refresh_clocks(std::uint64_t clocks) const {
    LineClocks whole;
    const std::uint64_t shown = lines_ * pixels_;
    const std::uint64_t end = lines_ == 0 ? 0 : mark_ + drain();
    whole.add(LineActivity::showing, shown);
    whole.add(LineActivity::waiting_for_line, end - shown);
    whole.add(LineActivity::done, clocks - end);
    return whole;
  }

 private:
  /// The `beats` clocks in which the last packet's beats were at the entry: a beat at the entry from edge n to the next
  /// edge is there in clock n - 1.
  [[nodiscard]] machines::ClockSpan entering(std::uint64_t beats) const { return {entered_ - beats, entered_}; }

  /// Span of the first beat of a packet: if no packet clears, the line's first packet clears in its first beat.
  static machines::ClockSpan first_beat(const machines::ClockSpan& packet) { return {packet.begin, packet.begin + 1}; }

  [[nodiscard]] std::uint64_t words_of(const isa::Command& command) const {
    return isa::wire_words(command, machine_.link.width);
  }

  /// Sends a command and its packet.
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
    const Edge requested = taken_by_entry_ + beats - 1;
    entered_ = is_mark ? std::max(requested, mark_from_) : requested;
    entry_.add(LineActivity::waiting_for_refresh, entered_ - requested);
    if (first_packet_ == 0) first_packet_ = entered_;
    if (is_mark) end_line();
  }

  /// Returns the edge at which the next word enters the FIFO.
  Edge store() {
    const Edge requested = sent_ + machine_.link.word_clocks;
    const Edge room = reads_.size() < machine_.link.fifo_depth ? 0 : reads_.front() + 1;
    sent_ = std::max(requested, room);
    link_.add(LineActivity::sending, machine_.link.word_clocks);
    link_.add(LineActivity::waiting_for_entry, sent_ - requested);
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
  std::uint64_t through_cells_;  ///< clocks from the entry until a beat has passed the line's last cell
  std::uint64_t budget_;
  isa::Field colour_;

  Edge taken_ = 0;           ///< edge at which the link took the last line from the host
  Edge sent_ = 0;            ///< edge at which the last word entered the FIFO
  Edge read_ = 0;            ///< edge at which that word was read
  std::deque<Edge> reads_;   ///< edges of the last reads, at most the depth of the FIFO
  Edge taken_by_entry_ = 0;  ///< edge at which the entry took the last command
  Edge entered_ = 0;         ///< edge of the last packet's last beat
  Edge mark_ = 0;            ///< edge of the last mark's last beat
  Edge mark_from_ = 0;       ///< first edge at which the next mark may enter
  Edge first_packet_ = 0;    ///< edge of the last beat of the frame's first packet
  std::uint64_t lines_ = 0;
  std::uint64_t words_ = 0;
  std::uint64_t late_lines_ = 0;
  LineClocks link_;
  LineClocks entry_;
};

/// Per chain: the edge from which its next mark may enter, counted from the start of the frame.
using MarkEdges = std::vector<Edge>;

/// Computes the timing of a frame. `marks`: edges that the previous frame determined; replaced by those that this frame
/// determines.
LineTiming time_frame(const isa::Program& program, const Machine& machine, std::span<const Cost> costs,
                      MarkEdges& marks, machines::Timeline* timeline = nullptr) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  const std::uint64_t pixels = program.shape.width;
  const isa::Field colour = isa::frame_header(program).colour;
  LineAccount counted{.lines = program.segments.size(), .line_budget = line_budget(machine, program.shape.height)};
  std::vector<ChainTiming> chains;
  for (const Edge mark : marks) chains.emplace_back(machine, program.shape, colour, mark);

  const std::vector<std::uint64_t> visits = active_visits(program);
  const std::uint64_t sorting = program.extents.size() * figures.bucket_clocks;
  counted.host.add(LineActivity::sorting, sorting);
  Edge host = sorting;  // last edge at which the host worked
  for (std::size_t line = 0; line < program.segments.size(); ++line) {
    const isa::Segment& segment = program.segments[line];
    ChainTiming& chain = chains[line % chains.size()];
    const std::uint64_t updating = visits[line] * figures.active_clocks;
    const std::uint64_t preparing = segment.instructions.size() * figures.instruction_clocks;
    const Edge requested = host + updating + preparing + 1;
    host = std::max(requested, chain.free_from());
    counted.host.add(LineActivity::updating, updating);
    counted.host.add(LineActivity::preparing, preparing);
    counted.host.add(LineActivity::waiting_for_link, host - requested);
    counted.host.add(LineActivity::starting, 1);
    const std::span<const Cost> line_costs = costs.first(segment.instructions.size());
    costs = costs.subspan(line_costs.size());
    chain.draw(segment, line_costs, host, timeline, line);

    counted.packets += segment.instructions.size();
    counted.max_packets = std::max<std::uint64_t>(counted.max_packets, segment.instructions.size());
    for (const Cost& cost : line_costs) counted.busy_cells += cost.beats * pixels;
  }

  const auto latest = std::max_element(chains.begin(), chains.end(),
                                       [](const auto& one, const auto& other) { return one.mark() < other.mark(); });
  counted.drain_clocks = latest->drain();
  const std::uint64_t clocks = latest->mark() + counted.drain_clocks;
  counted.host.add(LineActivity::done, clocks - host);
  counted.link = latest->link_clocks(clocks);
  counted.entry = latest->entry_clocks(clocks);
  counted.refresh = latest->refresh_clocks(clocks);
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
  const std::uint64_t word = std::max(machines::kind_figures<Figures>(machine).word_bits, 1U);
  if (instruction.opcode == isa::Opcode::squares) return 1;
  const Figures& figures = machines::kind_figures<Figures>(machine);
  const std::uint64_t delivered =
      figures.network == Network::trees ? std::min<std::uint64_t>(figures.tree_bits, word) : word;
  return std::max<std::uint64_t>({quotient_up(instruction.linear.width, delivered),
                                  quotient_up(machines::widest_field_bits(instruction), word), 1});
}

std::uint64_t Kind::clocks(const isa::Instruction& instruction, const Machine& machine) const {
  const Figures& figures = machines::kind_figures<Figures>(machine);
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
    return occupied_clocks(packet_words(instruction, machine), read, work, written, figures);
  const std::uint64_t reads = figures.ports == 0 ? 0 : quotient_up(read, figures.ports);
  return occupied_clocks(reads + work, read, 0, written, figures);
}

std::uint64_t line_budget(const Machine& machine, std::uint32_t picture_height) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  const std::uint64_t field_lines = figures.interlaced ? (picture_height + 1ULL) / 2 : picture_height;
  return figures.chains * (machine.clock_hz / (figures.refresh_hz * field_lines));
}

LineTiming time_lines(const isa::Program& program, const Machine& machine, machines::Timeline* timeline) {
  MarkEdges marks(machines::kind_figures<Figures>(machine).chains);
  const std::vector<Cost> costs = costs_of(program, machine);
  LineTiming alone = time_frame(program, machine, costs, marks, timeline);
  for (unsigned frame = 0; frame < frames_to_settle; ++frame) {
    const MarkEdges before = marks;
    alone.interval_clocks = time_frame(program, machine, costs, marks).interval_clocks;
    if (marks == before) break;
  }
  return alone;
}

std::vector<LineTiming> time_line_sequence(std::span<const isa::Program> frames, const Machine& machine) {
  MarkEdges marks(machines::kind_figures<Figures>(machine).chains);
  std::vector<LineTiming> timings;
  for (const isa::Program& frame : frames)
    timings.push_back(time_frame(frame, machine, costs_of(frame, machine), marks));
  return timings;
}

machines::FrameTiming Kind::time(const isa::Program& program, const Machine& machine,
                                 const machines::RunOutcome& /*outcomes*/) const {
  const LineTiming timing = time_lines(program, machine);
  return {.clocks = timing.clocks,
          .shown_clocks = timing.clocks,
          .interval_clocks = timing.interval_clocks,
          .account = account(timing.account, machine, timing.clocks)};
}

std::optional<machines::Timeline> Kind::timeline(const isa::Program& program, const Machine& machine,
                                                 const machines::RunOutcome& /*outcomes*/) const {
  machines::Timeline result = machines::blank_timeline(program);
  time_lines(program, machine, &result);
  return result;
}

std::vector<machines::ClockSpan> Kind::spans_at_pixel(const machines::Timeline& timeline, const isa::Program& program,
                                                      const Machine& machine, std::uint32_t segment, std::uint32_t x,
                                                      std::uint32_t /*y*/) const {
  const std::uint32_t cell = x - program.segments[segment].region.x;
  return machines::shifted(timeline.issued[segment],
                           clocks_to_cell(figures_of(machine).network, machine.array.width, cell));
}

}  // namespace csgsim::scan_line
