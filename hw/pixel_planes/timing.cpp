#include "hw/pixel_planes/timing.h"

#include <algorithm>
#include <vector>

#include "hw/isa/opcodes.h"
#include "hw/isa/wire.h"
#include "hw/machines/clocks.h"
#include "hw/machines/link_timing.h"
#include "hw/pixel_planes/account.h"
#include "hw/pixel_planes/figures.h"

namespace csgsim::pixel_planes {

namespace {

/// What the link and the controller have to do for a command.
struct Task {
  enum class Kind : std::uint8_t { clear, instruction, question, end };

  Kind kind = Kind::end;
  std::uint32_t words = 0;       ///< of the link
  std::uint64_t clocks = 0;      ///< of the controller, until the next command can begin
  std::uint64_t jumps_over = 0;  ///< tasks after it that are left out
};

bool is_question(const isa::Instruction& instruction) {
  return isa::info(instruction.opcode).clock_class == isa::ClockClass::answer;
}

std::vector<Task> tasks_of(const isa::Program& program, const machines::Machine& machine,
                           std::span<const machines::Skip> skips) {
  std::vector<Task> tasks;
  const auto words = [&](const isa::Command& command) { return isa::wire_words(command, machine.link.width); };
  for (std::uint32_t s = 0; s < program.segments.size(); ++s) {
    const isa::Segment& segment = program.segments[s];
    tasks.push_back(
        {Task::Kind::clear, words(isa::SegmentStart{segment.region}), std::max(machine.clear_clocks, 1U), 0});
    for (std::uint32_t i = 0; i < segment.instructions.size(); ++i) {
      const isa::Instruction& instruction = segment.instructions[i];
      Task& task = tasks.emplace_back();
      task.kind = is_question(instruction) ? Task::Kind::question : Task::Kind::instruction;
      task.words = words(instruction);
      task.clocks = instruction_clocks(instruction, machine);
      if (skips.empty() || skips.front() != machines::Skip{s, i}) continue;
      task.jumps_over = instruction.constant;
      skips = skips.subspan(1);
    }
  }
  tasks.push_back({Task::Kind::end, words(isa::FrameEnd{}), 0, 0});
  return tasks;
}

/// Edges are numbered from the frame's first. A word read at an edge that completes a command lets the command begin at
/// the next; the edge at which a command begins is the first at which a word of the one after it is read.
class FrameModel {
 public:
  FrameModel(const machines::Machine& machine, std::vector<Task> tasks)
      : machine_(machine), link_(machine.link), tasks_(std::move(tasks)) {}

  machines::FrameTiming time() {
    link_.request(1);
    for (std::size_t i = 0; i < tasks_.size(); i += 1 + tasks_[i].jumps_over) {
      receive(tasks_[i]);
      begin(tasks_[i]);
      if (tasks_[i].jumps_over > 0) jump(i);
    }
    link_.stop(free_, false);
    return {.clocks = free_,
            .latency_clocks = account_.draining,
            .account = account(account_, link_.account(), machine_.link, instructions_)};
  }

 private:
  void receive(const Task& task) {
    for (std::uint32_t word = 0; word < task.words; ++word) {
      const std::uint64_t stored = link_.send();
      read_ = std::max({stored + 1, read_ + 1, word == 0 ? begun_ : 0});
      link_.read(read_);
    }
  }

  void begin(const Task& task) {
    begun_ = std::max(read_ + 1, free_);
    (jumped_ ? account_.jumping : account_.starved) += begun_ - free_;
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
        account_.answering += task.clocks - 1;
        ++instructions_;
        break;
      case Task::Kind::end:
        account_.draining = machines::evaluator_latency(machine_.array);
        free_ += account_.draining;
        break;
    }
  }

  /// The answer is there at the edge free_, and the host knows of it at the next. Until then it has gone on sending,
  /// and of the next command words have been read.
  void jump(std::size_t question) {
    const std::uint64_t known = free_ + 1;
    std::size_t task = question + 1;
    bool sent = true;
    for (; sent && task < tasks_.size(); task += sent ? 1 : 0) {
      for (std::uint32_t word = 0; sent && word < tasks_[task].words; ++word) {
        std::uint64_t stored = 0;
        sent = link_.send_before(known, stored);
        if (!sent || task != question + 1) continue;
        read_ = std::max({stored + 1, read_ + 1, word == 0 ? begun_ : 0});
        link_.read(read_);  // a word that could be read at free_ only makes room too late for another
      }
    }
    link_.stop(known, !sent);
    link_.request(known);
    read_ = known;
    jumped_ = true;
  }

  const machines::Machine& machine_;
  machines::LinkTiming link_;
  std::vector<Task> tasks_;
  std::uint64_t read_ = 0;   ///< edge at which the last word was read
  std::uint64_t begun_ = 0;  ///< edge at which the last command began
  std::uint64_t free_ = 0;   ///< edge at which the next can begin
  bool jumped_ = false;      ///< between the last command and the next
  std::uint64_t instructions_ = 0;
  ControllerAccount account_;
};

struct ScanOutClocks {
  std::uint64_t shown = 0;    ///< until the last pixel has been shown
  std::uint64_t latched = 0;  ///< until the last row has been latched
};

/// A row is latched while the one before it is shown, but for the first; whichever takes longer sets the pace. At a
/// shared port a row's first bit is there when the request has reached the controller and its word the pixels.
ScanOutClocks scan_out_clocks(const machines::Machine& machine, std::uint64_t colour_bits) {
  const auto& figures = machines::own<Figures>(machine);
  const std::uint64_t way = machines::evaluator_latency(machine.array) + 2;
  const std::uint64_t latch = colour_bits + (figures.scan_out_port == ScanOutPort::shared ? way : 0);
  const std::uint64_t show = (machine.array.width + figures.scan_out_pixels - 1) / figures.scan_out_pixels;
  const std::uint64_t rows = machine.array.height;
  const std::uint64_t pace = std::max(latch, show);
  return {.shown = latch + (rows - 1) * pace + show, .latched = rows == 1 ? latch : 2 * latch + (rows - 2) * pace};
}

}  // namespace

std::uint32_t or_levels(std::uint64_t lines, std::uint32_t fan_in) {
  std::uint32_t levels = 0;
  if (fan_in == 0) return levels;
  for (std::uint64_t reach = 1; reach < lines; reach *= fan_in) ++levels;
  return levels;
}

std::uint64_t interval_clocks(std::uint64_t drawing, std::uint64_t shown, std::uint64_t latched) {
  return std::max(latched + 1 + drawing, shown);
}

std::uint64_t instruction_clocks(const isa::Instruction& instruction, const machines::Machine& machine) {
  const std::uint64_t clocks = machines::bit_serial_clocks(instruction, machine);
  if (!is_question(instruction)) return clocks;
  return clocks + or_levels(std::uint64_t{machine.array.width} * machine.array.height,
                            machines::own<Figures>(machine).or_fan_in);
}

machines::FrameTiming time_frame(const isa::Program& program, const machines::Machine& machine,
                                 std::span<const machines::Skip> skips) {
  machines::FrameTiming timing = FrameModel(machine, tasks_of(program, machine, skips)).time();
  const std::uint32_t colour_bits = isa::field_of(program, isa::FieldRole::colour).width;
  if (colour_bits == 0) return timing;
  const ScanOutClocks scan_out = scan_out_clocks(machine, colour_bits);
  timing.shown_clocks = timing.clocks + scan_out.shown;
  timing.interval_clocks = interval_clocks(timing.clocks, scan_out.shown, scan_out.latched);
  return timing;
}

}  // namespace csgsim::pixel_planes
