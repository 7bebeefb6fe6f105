#include "hw/pixel_planes/timing.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "hw/isa/opcodes.h"
#include "hw/isa/wire.h"
#include "hw/machines/clocks.h"
#include "hw/machines/link_timing.h"
#include "hw/machines/regions.h"
#include "hw/pixel_planes/account.h"
#include "hw/pixel_planes/figures.h"
#include "hw/pixel_planes/kind.h"
#include "hw/pixel_planes/scan_out_timing.h"

namespace csgsim::pixel_planes {

namespace {

constexpr unsigned max_frames_tried = 8;

/// Work of the link and the controller for one command.
struct Task {
  enum class Kind : std::uint8_t { clear, instruction, question, end };

  Kind kind = Kind::end;
  std::uint32_t words = 0;     ///< words on the link
  std::uint64_t clocks = 0;    ///< clocks of the controller until the next command can begin
  std::size_t jumps_over = 0;  ///< number of tasks skipped after this one
};

std::vector<Task> make_tasks(const isa::Program& program, const machines::Machine& machine,
                             std::span<const machines::Skip> skips) {
  std::vector<Task> tasks;
  tasks.reserve(program.segments.size() + isa::total_instructions(program) + 1);
  const auto words = [&](const isa::Command& command) { return isa::wire_words(command, machine.link.width); };
  for (std::uint32_t s = 0; s < program.segments.size(); ++s) {
    const isa::Segment& segment = program.segments[s];
    tasks.push_back(
        {Task::Kind::clear, words(isa::SegmentStart{segment.region}), std::max(machine.clear_clocks, 1U), 0});
    for (std::uint32_t i = 0; i < segment.instructions.size(); ++i) {
      const isa::Instruction& instruction = segment.instructions[i];
      Task& task = tasks.emplace_back();
      task.kind = isa::needs_global_or(instruction.opcode) ? Task::Kind::question : Task::Kind::instruction;
      task.words = words(instruction);
      task.clocks = machines::clocks(instruction, machine);
      if (skips.empty() || skips.front() != machines::Skip{s, i}) continue;
      task.jumps_over = static_cast<std::size_t>(instruction.constant);
      skips = skips.subspan(1);
    }
  }
  tasks.push_back({Task::Kind::end, words(isa::FrameEnd{}), 0, 0});
  return tasks;
}

/// Clocks to copy a finished picture with `colour_bits` colour bits: the steps of enable_all and copy.
std::uint64_t copy_clocks(std::uint32_t colour_bits, const machines::Machine& machine) {
  if (machines::second_buffer(colour_bits, machine).width == 0) return 0;
  const auto width = static_cast<std::uint16_t>(colour_bits);
  return machines::bit_serial_clocks({.opcode = isa::Opcode::enable_all}, machine) +
         machines::bit_serial_clocks({.opcode = isa::Opcode::copy, .fields = {{{0, width}, {0, width}}}}, machine);
}

/// Timing of one frame. Edges are numbered from the frame's first. If the word read at an edge completes a command, the
/// command begins at the next edge; from the edge at which a command begins, words of the next command are read.
class FrameModel {
 public:
  /// `shown`: scan-out of the previous picture, or null; in its numbering the frame's first edge is `first`. `spans`:
  /// receives the clocks of each executed task, unless null.
  FrameModel(const machines::Machine& machine, const std::vector<Task>& tasks, std::uint64_t copy_clocks,
             ScanOutTiming* shown, std::uint64_t first, std::vector<machines::ClockSpan>* spans = nullptr)
      : machine_(machine),
        link_(machine.link),
        tasks_(tasks),
        copy_clocks_(copy_clocks),
        shown_(shown),
        first_(first),
        spans_(spans) {}

  machines::FrameTiming time() {
    link_.record_request(1);
    for (std::size_t i = 0; i < tasks_.size(); i += 1 + tasks_[i].jumps_over) {
      receive(tasks_[i]);
      begin(tasks_[i]);
      if (spans_ != nullptr) (*spans_)[i] = {begun_, free_};
      if (i == watched_) {
        moment_ = moment();
        return {};
      }
      if (tasks_[i].jumps_over > 0) jump(i);
    }
    link_.account_until(free_, false);
    return {.clocks = free_,
            .latency_clocks = machines::evaluator_latency(machine_),
            .account = account(account_, link_.account(), machine_, instructions_)};
  }

  /// Makes time() stop at the given task, if it is executed, and record its moment; the timing is then not valid. Must
  /// be called before time().
  void watch(std::size_t task) { watched_ = task; }
  [[nodiscard]] const std::optional<Moment>& watched() const { return moment_; }

 private:
  /// Determines on a copy of the link which words are sent before the edge at which a command begins. Later words are
  /// read from that edge on, so they free no room before it.
  [[nodiscard]] Moment moment() const {
    machines::LinkTiming link = link_;
    const std::uint64_t read = first_word_ + link.words_read();
    const std::uint64_t left = first_word_ + count_words(first_task_, tasks_.size()) - read;
    std::uint64_t stored = 0;
    while (link.sent() - link.words_read() < left && link.try_send_before(begun_, stored)) continue;
    return {.clock = begun_,
            .words_read = read,
            .words_sent = first_word_ + link.sent(),
            .clocks_left = link.clocks_left(begun_)};
  }

  /// Words of the tasks in [from, until).
  [[nodiscard]] std::uint64_t count_words(std::size_t from, std::size_t until) const {
    std::uint64_t words = 0;
    for (std::size_t task = from; task < until; ++task) words += tasks_[task].words;
    return words;
  }

  void receive(const Task& task) {
    for (std::uint32_t word = 0; word < task.words; ++word) {
      const std::uint64_t stored = link_.send();
      read_ = std::max({stored + 1, read_ + 1, word == 0 ? begun_ : 0});
      link_.read_word(read_);
    }
  }

  void begin(const Task& task) {
    begin_after_refreshing();
    jumped_ = false;
    free_ = begun_ + task.clocks;
    switch (task.kind) {
      case Task::Kind::clear: account_.clearing += task.clocks; break;
      case Task::Kind::instruction:
        account_.issuing += task.clocks;
        ++instructions_;
        break;
      case Task::Kind::question:
        ++account_.issuing;
        account_.answering += waited(begun_ + 1, free_);
        ++instructions_;
        break;
      case Task::Kind::end: end(); break;
    }
  }

  /// Begins the command when it has arrived, the previous command is over, and no refresh word is requested at the
  /// edge.
  void begin_after_refreshing() {
    const std::uint64_t ready = std::max(read_ + 1, free_);
    std::uint64_t& waiting = jumped_ ? account_.jumping : account_.starved;
    waiting += waited(free_, ready);
    for (begun_ = ready; refresh_at(begun_, begun_ + 1) != none; ++begun_) continue;
  }

  /// Copies the picture when the previous picture has been latched, then waits until the last step has reached the
  /// pixels.
  void end() {
    if (copy_clocks_ > 0) {
      const std::uint64_t latched = shown_ == nullptr ? free_ : latched_after(free_);
      account_.holding += waited(free_, latched);
      account_.copying += copy_clocks_;
      free_ = latched + copy_clocks_;
    }
    const std::uint64_t latency = machines::evaluator_latency(machine_);
    account_.draining += waited(free_, free_ + latency);
    free_ += latency;
  }

  /// The first edge from `edge` on at which the previous picture is known to be latched, if every refresh word is sent
  /// as soon as it is requested.
  [[nodiscard]] std::uint64_t latched_after(std::uint64_t edge) const {
    ScanOutTiming shown = *shown_;
    shown.record_remaining_words(first_ + edge);
    return std::max(shown.latched(), first_ + edge) - first_;
  }

  /// Sends the refresh words requested in [from, to). Returns the number of other clocks.
  std::uint64_t waited(std::uint64_t from, std::uint64_t to) {
    std::uint64_t clocks = to - from;
    for (std::uint64_t edge = from; (edge = refresh_at(edge, to)) != none; ++edge) --clocks;
    return clocks;
  }

  /// Sends the first refresh word requested in [from, before). Returns its edge, or `none`.
  std::uint64_t refresh_at(std::uint64_t from, std::uint64_t before) {
    if (shown_ == nullptr || shown_->request() == none) return none;
    const std::uint64_t edge = std::max(first_ + from, shown_->request());
    if (edge >= first_ + before) return none;
    account_.refresh_waits += edge - shown_->request();
    ++account_.refreshing;
    shown_->record_refresh_word(edge);
    return edge - first_;
  }

  /// Jumps after a question. The answer arrives at edge free_, and the host receives the request at the next edge.
  /// Until then the host keeps sending, and words of the next command are read.
  void jump(std::size_t question) {
    const std::uint64_t known = free_ + 1;
    std::size_t task = question + 1;
    bool sent = true;
    for (; sent && task < tasks_.size(); task += sent ? 1 : 0) {
      for (std::uint32_t word = 0; sent && word < tasks_[task].words; ++word) {
        std::uint64_t stored = 0;
        sent = link_.try_send_before(known, stored);
        if (!sent || task != question + 1) continue;
        read_ = std::max({stored + 1, read_ + 1, word == 0 ? begun_ : 0});
        link_.read_word(read_);  // reading a word at free_ itself would make room too late for another word
      }
    }
    link_.account_until(known, !sent);
    link_.record_request(known);
    const std::size_t next_task = question + 1 + tasks_[question].jumps_over;
    first_word_ += count_words(first_task_, next_task);
    first_task_ = next_task;
    read_ = known;
    jumped_ = true;
  }

  static constexpr std::uint64_t none = ScanOutTiming::never;

  const machines::Machine& machine_;
  machines::LinkTiming link_;
  const std::vector<Task>& tasks_;
  std::uint64_t copy_clocks_;
  ScanOutTiming* shown_;
  std::uint64_t first_;
  std::vector<machines::ClockSpan>* spans_;
  std::size_t watched_ = std::numeric_limits<std::size_t>::max();  ///< task at which to stop
  std::optional<Moment> moment_;
  std::size_t first_task_ = 0;    ///< first task since the last request
  std::uint64_t first_word_ = 0;  ///< its first word, counted in the frame
  std::uint64_t read_ = 0;        ///< edge at which the last word was read
  std::uint64_t begun_ = 0;       ///< edge at which the last command began
  std::uint64_t free_ = 0;        ///< edge at which the next command can begin
  bool jumped_ = false;           ///< whether the last command was followed by a jump
  std::uint64_t instructions_ = 0;
  ControllerAccount account_;
};

/// Timing of frames in sequence. Edges are numbered from the first frame's first edge.
class SequenceModel {
 public:
  explicit SequenceModel(const machines::Machine& machine)
      : machine_(machine), two_buffers_(machines::kind_figures<Figures>(machine).scan_out_buffers >= 2) {}

  void draw(const std::vector<Task>& tasks, std::uint32_t colour_bits) {
    FrameModel frame(machine_, tasks, copy_clocks(colour_bits, machine_), shown_ ? &*shown_ : nullptr, begin_);
    add(frame.time(), colour_bits);
  }

  /// Adds the next frame, with the timing of its drawing.
  void add(machines::FrameTiming frame, std::uint32_t colour_bits) {
    timings_.push_back(std::move(frame));
    const std::uint64_t drawn = begin_ + timings_.back().clocks;
    if (shown_ && shown_->request() <= drawn) shown_->record_refresh_word(drawn);
    std::uint64_t next = drawn + 1;
    if (colour_bits > 0) {
      show(drawn + 1, colour_bits);
      if (!two_buffers_) {
        shown_->record_remaining_words(drawn);
        next = shown_->latched();
      }
    }
    timings_.back().interval_clocks = next - begin_;
    begin_ = next;
  }

  /// Clocks from the beginning of the next frame until the scan-out of the last picture begins.
  [[nodiscard]] std::uint64_t scan_out_after() const { return std::max(scan_out_begin_, begin_) - begin_; }

  /// Timing of all frames; the last picture is shown completely.
  std::vector<machines::FrameTiming> finish() {
    if (shown_) shown_->record_remaining_words(begin_);
    end_picture();
    return std::move(timings_);
  }

 private:
  /// Begins the scan-out of the last frame's picture; the previous picture, if any, has been latched.
  void show(std::uint64_t from, std::uint32_t colour_bits) {
    end_picture();
    scan_out_begin_ = shown_ ? std::max(from, shown_->over()) : from;
    shown_.emplace(machine_, colour_bits, scan_out_begin_);
    shown_frame_ = timings_.size() - 1;
    shown_begin_ = begin_;
  }

  void end_picture() {
    if (shown_) timings_[shown_frame_].shown_clocks = shown_->over() - 1 - shown_begin_;
  }

  const machines::Machine& machine_;
  bool two_buffers_;
  std::vector<machines::FrameTiming> timings_;
  std::uint64_t begin_ = 0;  ///< edge at which the next frame begins
  std::optional<ScanOutTiming> shown_;
  std::size_t shown_frame_ = 0;       ///< frame whose picture is shown
  std::uint64_t shown_begin_ = 0;     ///< edge at which that frame began
  std::uint64_t scan_out_begin_ = 0;  ///< edge at which the scan-out of its picture begins
};

/// Interval in a long sequence of the same Program. Simulates up to max_frames_tried frames, until the scan-out begins
/// as long after the frame's beginning as in the previous frame. `alone`: timing of a single frame. With one buffer no
/// picture is scanned out while another is drawn, so all frames have the same timing.
std::uint64_t steady_interval(const machines::FrameTiming& alone, const std::vector<Task>& tasks,
                              std::uint32_t colour_bits, const machines::Machine& machine) {
  const bool two_buffers = machines::kind_figures<Figures>(machine).scan_out_buffers >= 2;
  SequenceModel model(machine);
  model.add(alone, colour_bits);
  std::uint64_t before = ScanOutTiming::never;
  for (unsigned i = 1; i < max_frames_tried && model.scan_out_after() != before; ++i) {
    before = model.scan_out_after();
    if (two_buffers)
      model.draw(tasks, colour_bits);
    else
      model.add(alone, colour_bits);
  }
  return model.finish().back().interval_clocks;
}

}  // namespace

std::uint32_t or_levels(std::uint64_t lines, std::uint32_t fan_in) {
  std::uint32_t levels = 0;
  if (fan_in == 0) return levels;
  for (std::uint64_t reach = 1; reach < lines; reach *= fan_in) ++levels;
  return levels;
}

std::uint64_t Kind::clocks(const isa::Instruction& instruction, const machines::Machine& machine) const {
  const std::uint64_t steps = machines::bit_serial_clocks(instruction, machine);
  if (!isa::needs_global_or(instruction.opcode)) return steps;
  return steps + or_levels(std::uint64_t{machine.array.width} * machine.array.height,
                           machines::kind_figures<Figures>(machine).or_fan_in);
}

machines::FrameTiming Kind::time(const isa::Program& program, const machines::Machine& machine,
                                 const machines::RunOutcome& outcome) const {
  const std::vector<Task> tasks = make_tasks(program, machine, outcome.skips);
  const std::uint32_t colour_bits = program.colour.width;
  SequenceModel model(machine);
  model.draw(tasks, colour_bits);
  machines::FrameTiming timing = model.finish().front();
  timing.interval_clocks = steady_interval(timing, tasks, colour_bits, machine);
  return timing;
}

std::optional<machines::Timeline> Kind::timeline(const isa::Program& program, const machines::Machine& machine,
                                                 const machines::RunOutcome& outcome) const {
  const std::vector<Task> tasks = make_tasks(program, machine, outcome.skips);
  std::vector<machines::ClockSpan> spans(tasks.size());
  FrameModel(machine, tasks, 0, nullptr, 0, &spans).time();
  machines::Timeline timeline;
  auto next = spans.begin();
  for (const isa::Segment& segment : program.segments) {
    timeline.cleared.push_back(*next++);
    const auto end = next + static_cast<std::ptrdiff_t>(segment.instructions.size());
    timeline.issued.emplace_back(next, end);
    next = end;
  }
  return timeline;
}

Moment instruction_moment(const isa::Program& program, const machines::Machine& machine,
                          std::span<const machines::Skip> skips, std::uint32_t segment, std::uint32_t index) {
  const std::vector<Task> tasks = make_tasks(program, machine, skips);
  std::size_t task = segment + 1 + index;  // the start of each segment is also a task
  for (std::uint32_t s = 0; s < segment; ++s) task += program.segments[s].instructions.size();
  const std::uint32_t colour_bits = program.colour.width;
  FrameModel frame(machine, tasks, copy_clocks(colour_bits, machine), nullptr, 0);
  frame.watch(task);
  frame.time();
  if (!frame.watched()) throw std::logic_error("an instruction that is not executed has no moment");
  return *frame.watched();
}

std::vector<machines::ClockSpan> Kind::spans_at_pixel(const machines::Timeline& timeline, const isa::Program& program,
                                                      const machines::Machine& machine, std::uint32_t segment,
                                                      std::uint32_t /*x*/, std::uint32_t /*y*/) const {
  const std::vector<isa::Instruction>& instructions = program.segments[segment].instructions;
  std::vector<machines::ClockSpan> steps = timeline.issued[segment];
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!steps[i].empty() && isa::needs_global_or(instructions[i].opcode)) steps[i].end = steps[i].begin + 1;
  }
  return machines::shifted(std::move(steps), machines::evaluator_latency(machine));
}

std::vector<machines::FrameTiming> time_sequence(std::span<const DrawnFrame> frames, const machines::Machine& machine) {
  SequenceModel model(machine);
  for (const DrawnFrame& frame : frames)
    model.draw(make_tasks(*frame.program, machine, frame.skips), frame.program->colour.width);
  return model.finish();
}

}  // namespace csgsim::pixel_planes
