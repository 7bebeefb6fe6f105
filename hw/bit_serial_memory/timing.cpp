#include "hw/bit_serial_memory/timing.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hw/bit_serial_memory/gate_mapper.h"
#include "hw/bit_serial_memory/kind.h"
#include "hw/bit_serial_memory/micro_program.h"
#include "hw/bit_serial_memory/row_map.h"
#include "hw/bit_serial_memory/timing_link.h"
#include "hw/bit_serial_memory/timing_rows.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/wire.h"

namespace csgsim::bit_serial_memory {

namespace {

using machines::ClockSpan;
using machines::Machine;

/// The controller takes one clock to receive a command before its row commands.
constexpr std::uint64_t taking_clocks = 1;

RowMap map_of(const Machine& machine) {
  return {machine.array.memory_bits, machine.picture.width, machine.picture.height};
}

/// Work of the link and the controller for one command.
struct Task {
  enum class Kind : std::uint8_t { clear, instruction, question, end };

  Kind kind = Kind::end;
  std::uint64_t link_clocks = 0;
  const isa::Instruction* instruction = nullptr;
  std::size_t jumps_over = 0;  ///< number of following tasks that are skipped
  std::uint64_t number = 0;    ///< of the segment or, in the whole Program, of the instruction
};

std::vector<Task> tasks_of(const isa::Program& program, const Machine& machine, std::span<const machines::Skip> skips) {
  std::vector<Task> tasks;
  std::uint64_t number = 0;
  const auto clocks = [&](const isa::Command& command) {
    return std::uint64_t{isa::wire_words(command, machine.link.width)} * machine.link.word_clocks;
  };
  for (std::uint32_t s = 0; s < program.segments.size(); ++s) {
    const isa::Segment& segment = program.segments[s];
    tasks.push_back({Task::Kind::clear, clocks(isa::SegmentStart{segment.region}), nullptr, 0, s});
    for (std::uint32_t i = 0; i < segment.instructions.size(); ++i) {
      const isa::Instruction& instruction = segment.instructions[i];
      const bool needs_global_or = isa::needs_global_or(instruction.opcode);
      tasks.push_back({needs_global_or ? Task::Kind::question : Task::Kind::instruction, clocks(instruction),
                       &instruction, 0, number++});
      if (skips.empty() || skips.front() != machines::Skip{s, i}) continue;
      tasks.back().jumps_over = static_cast<std::size_t>(instruction.constant);
      skips = skips.subspan(1);
    }
  }
  tasks.push_back({Task::Kind::end, clocks(isa::FrameEnd{}), nullptr, 0, 0});
  return tasks;
}

bool is_drawn(const isa::Program& program) {
  return program.colour.width > 0 && std::ranges::any_of(program.segments, [](const isa::Segment& segment) {
           return !segment.instructions.empty();
         });
}

/// Clocks count from the frame's first, 0, in which the controller requests it. A command whose last word arrives at an
/// edge can begin at the next, once the previous command has finished.
class FrameModel {
 public:
  FrameModel(const isa::Program& program, const Machine& machine, std::span<const machines::Skip> skips,
             RowListener* listener = nullptr, const CommandSet* set = nullptr)
      : machine_(machine),
        figures_(machines::kind_figures<Figures>(machine)),
        slots_(slots_of(machine)),
        map_(map_of(machine)),
        tasks_(tasks_of(program, machine, skips)),
        listener_(listener),
        mapper_(set == nullptr ? std::nullopt : std::optional<GateMapper>(*set)),
        rank_(figures_, slots_, listener),
        link_(figures_.queue, machine.link.latency),
        spans_(tasks_.size()) {}

  machines::FrameTiming time(isa::Field shown) {
    for (std::size_t i = 0; i < tasks_.size(); i += 1 + tasks_[i].jumps_over) {
      begin(tasks_[i]);
      carry_out(tasks_[i]);
      spans_[i] = {task_start_, free_};
      if (tasks_[i].jumps_over > 0) jump(i);
    }
    const std::uint64_t clocks = free_;
    const std::uint64_t refreshing = rank_.refreshing();
    account_.sending = link_.sending();
    const std::uint64_t shown_clocks = scan_out(shown, clocks);
    account_.scan_out_clocks = shown_clocks - clocks;
    account_.controller.refreshing = refreshing;
    account_.work.refreshes = rank_.refreshes();
    return {
        .clocks = clocks, .shown_clocks = shown_clocks, .account = account(account_, clocks, shown_clocks, machine_)};
  }

  [[nodiscard]] const std::vector<ClockSpan>& spans() const { return spans_; }

 private:
  void begin(const Task& task) {
    const std::uint64_t ready = link_.arrival(task.link_clocks) + 1;
    const std::uint64_t refreshed = rank_.refreshing();
    task_start_ = rank_.begin(free_, ready);
    link_.begin(task_start_);
    std::uint64_t& waiting = jumped_ ? account_.controller.jumping : account_.controller.starved;
    waiting += task_start_ - free_ - (rank_.refreshing() - refreshed);
    jumped_ = false;
    free_ = task_start_;
  }

  void report(const Task& task) {
    if (listener_ == nullptr) return;
    if (task.kind == Task::Kind::clear) return listener_->begin_segment(static_cast<std::uint32_t>(task.number));
    if (task.instruction != nullptr) listener_->begin_instruction(task.number, *task.instruction);
  }

  void carry_out(const Task& task) {
    report(task);
    const MicroDesign design = micro_design(figures_);
    ControllerAccount& controller = account_.controller;
    switch (task.kind) {
      case Task::Kind::clear: return spend(clear_program(map_, design), controller.clearing);
      case Task::Kind::instruction: return spend(micro_program(*task.instruction, map_, design), controller.issuing);
      case Task::Kind::question: return spend(micro_program(*task.instruction, map_, design), controller.answering);
      case Task::Kind::end: return;
    }
  }

  void spend(const RowCommands& gates, std::uint64_t& activity) {
    if (mapper_) return spend_mapped(mapper_->expand(gates), activity);
    spend_mapped(gates, activity);
  }

  void spend_mapped(const RowCommands& commands, std::uint64_t& activity) {
    const std::uint64_t refreshed = rank_.refreshing();
    free_ = rank_.carry_out(commands, task_start_ + taking_clocks);
    activity += free_ - task_start_ - (rank_.refreshing() - refreshed);
    count(commands);
  }

  void count(const RowCommands& commands) {
    for (const RowCommand& command : commands) add(command, slots_.count(), slots_.pixels, account_.work);
  }

  /// The host continues sending until it receives the request.
  void jump(std::size_t question) {
    for (std::size_t task = question + 1; task < tasks_.size() && link_.has_room(); ++task) {
      if (link_.next_start() >= free_) break;
      link_.arrival(tasks_[task].link_clocks);
    }
    link_.jump(free_);
    jumped_ = true;
  }

  std::uint64_t scan_out(isa::Field shown, std::uint64_t begin) {
    if (shown.width == 0) return begin;
    const RowCommands commands = send_program(shown);
    count(commands);
    if (listener_ != nullptr) listener_->begin_scan_out();
    return rank_.carry_out(commands, begin);
  }

  const Machine& machine_;
  const Figures& figures_;
  const Slots slots_;
  const RowMap map_;
  const std::vector<Task> tasks_;
  RowListener* listener_;
  std::optional<GateMapper> mapper_;
  RankTiming rank_;
  LinkTiming link_;
  std::vector<ClockSpan> spans_;
  std::uint64_t task_start_ = 0;
  std::uint64_t free_ = 0;
  bool jumped_ = false;
  FrameAccount account_;
};

Machine with_picture_of(const isa::Program& program, const Machine& machine) {
  Machine one = machine;
  machines::set_picture_size(one, {program.shape.width, program.shape.height});
  return one;
}

isa::Field shown_field(const isa::Program& program) { return is_drawn(program) ? program.colour : isa::Field{}; }

}  // namespace

std::uint64_t Kind::clocks(const isa::Instruction& instruction, const Machine& machine) const {
  const Figures& figures = figures_of(machine);
  return taking_clocks + RankTiming(figures, slots_of(machine))
                             .clocks(micro_program(instruction, map_of(machine), micro_design(figures)));
}

machines::FrameTiming Kind::time(const isa::Program& program, const Machine& machine,
                                 const RunOutcome& outcomes) const {
  const Machine one = with_picture_of(program, machine);
  return FrameModel(program, one, outcomes.skips).time(shown_field(program));
}

machines::FrameTiming time_rows(const isa::Program& program, const Machine& machine,
                                const machines::RunOutcome& outcomes, RowListener& listener, const CommandSet* set) {
  const Machine one = with_picture_of(program, machine);
  return FrameModel(program, one, outcomes.skips, &listener, set).time(shown_field(program));
}

std::optional<machines::Timeline> Kind::timeline(const isa::Program& program, const Machine& machine,
                                                 const RunOutcome& outcomes) const {
  const Machine one = with_picture_of(program, machine);
  FrameModel model(program, one, outcomes.skips);
  model.time(shown_field(program));
  machines::Timeline timeline;
  auto next = model.spans().begin();
  for (const isa::Segment& segment : program.segments) {
    timeline.cleared.push_back(*next++);
    const auto end = next + static_cast<std::ptrdiff_t>(segment.instructions.size());
    timeline.issued.emplace_back(next, end);
    next = end;
  }
  return timeline;
}

std::vector<ClockSpan> Kind::spans_at_pixel(const Timeline& timeline, const Program& /*program*/,
                                            const Machine& /*machine*/, std::uint32_t segment, std::uint32_t /*x*/,
                                            std::uint32_t /*y*/) const {
  return timeline.issued[segment];
}

}  // namespace csgsim::bit_serial_memory
