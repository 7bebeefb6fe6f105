#include <algorithm>
#include <deque>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "hw/machines/runs_on.h"
#include "hw/scan_line/scan_line_array.h"
#include "sim/cycle/kinds.h"
#include "sim/cycle/overflow.h"

namespace csgsim::sim {

namespace {

using scan_line::Keep;
using scan_line::Retired;
using scan_line::ScanLineArray;
using scan_line::Snapshot;

std::size_t row_words(const isa::Region& line) { return (line.width + 63) / 64; }

/// A line as a packet left it, each cell at its own clock: by cell the state at the instruction boundary.
class LineState final : public PixelState {
 public:
  LineState(const Snapshot& snapshot, isa::Region region) : snapshot_(snapshot), region_(region) {}

  [[nodiscard]] isa::Region region() const override { return region_; }

  void read_field(isa::Field field, std::span<std::uint32_t> values) const override {
    require(!snapshot_.memory.empty());
    for (std::uint32_t x = 0; x < region_.width; ++x) {
      values[x] = static_cast<std::uint32_t>(snapshot_.read(x, field));
    }
  }

  void read_enable(std::span<std::uint64_t> words) const override {
    require(!snapshot_.enable.empty());
    std::copy(snapshot_.enable.begin(), snapshot_.enable.end(), words.begin());
  }

 private:
  static void require(bool kept) {
    if (!kept) throw std::logic_error("an observer reads the state after an instruction without having said so");
  }

  const Snapshot& snapshot_;
  isa::Region region_;
};

/// An instruction of a line, or its end, as it is passed on.
struct Event {
  std::optional<Retired> retired;  ///< none: the end
  Snapshot snapshot;
};

/// Passes what the machine tells on to the observers, in program order: what comes of a line before the lines ahead of
/// it are through has to wait. Counts the overflows, which the machine does not notice.
class Relay final : public scan_line::RunListener {
 public:
  Relay(const isa::Program& program, std::span<Observer* const> observers)
      : program_(program), observers_(observers), waiting_(program.segments.size()) {}

  [[nodiscard]] Keep keeps_after(std::uint32_t segment, std::uint32_t index) const override {
    const isa::Segment& line = program_.segments[segment];
    const isa::Instruction& instruction = line.instructions[index];
    const auto reads = [&](const Observer* observer) { return observer->reads_after(instruction); };
    if (std::any_of(observers_.begin(), observers_.end(), reads)) return Keep::all;
    return next_can_overflow(line, index) ? Keep::enable : Keep::nothing;
  }

  void after_instruction(const Retired& retired, const Snapshot* snapshot) override {
    static const Snapshot nothing;
    count(retired, snapshot);
    if (retired.segment == next_) return pass_on(retired, snapshot == nullptr ? nothing : *snapshot);
    waiting_[retired.segment].push_back({retired, snapshot == nullptr ? nothing : *snapshot});
  }

  void after_line(std::uint32_t segment, const Snapshot& snapshot) override {
    if (segment != next_) return waiting_[segment].push_back({std::nullopt, snapshot});
    end_line(snapshot);
    while (next_ < waiting_.size() && !waiting_[next_].empty()) catch_up();
  }

  [[nodiscard]] std::uint64_t overflows() const { return overflows_; }

 private:
  [[nodiscard]] static bool next_can_overflow(const isa::Segment& line, std::uint32_t index) {
    return index + 1 < line.instructions.size() && can_overflow(line.instructions[index + 1].linear, line.region);
  }

  /// Overflows of the next instruction. A line's first finds no pixel enabled.
  void count(const Retired& retired, const Snapshot* snapshot) {
    const isa::Segment& line = program_.segments[retired.segment];
    if (!next_can_overflow(line, retired.index)) return;
    overflows_ += count_overflows(line.instructions[retired.index + 1].linear, line.region, snapshot->enable,
                                  row_words(line.region));
  }

  void pass_on(const Retired& retired, const Snapshot& snapshot) {
    const isa::Segment& line = program_.segments[retired.segment];
    const LineState state(snapshot, line.region);
    const Step step{.segment = retired.segment,
                    .index = retired.index,
                    .instruction = line.instructions[retired.index],
                    .clocks = retired.clocks,
                    .enabled_pixels = retired.enabled_pixels};
    for (Observer* observer : observers_) observer->after_instruction(step, state);
  }

  void end_line(const Snapshot& snapshot) {
    const LineState state(snapshot, program_.segments[next_].region);
    for (Observer* observer : observers_) observer->after_segment(next_, state);
    ++next_;
  }

  /// With what waits of the next line, whose end need not be among it.
  void catch_up() {
    const std::uint32_t line = next_;
    for (const Event& event : std::exchange(waiting_[line], {})) {
      event.retired ? pass_on(*event.retired, event.snapshot) : end_line(event.snapshot);
    }
  }

  const isa::Program& program_;
  std::span<Observer* const> observers_;
  std::uint32_t next_ = 0;                  ///< line whose end has not been passed on
  std::vector<std::deque<Event>> waiting_;  ///< one a line
  std::uint64_t overflows_ = 0;
};

/// The picture in row order.
std::vector<std::uint32_t> picture_of(const isa::Program& program,
                                      const std::vector<std::vector<std::uint32_t>>& lines) {
  std::vector<std::uint32_t> picture(std::size_t{program.shape.width} * program.shape.height);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::copy(lines[i].begin(), lines[i].end(),
              &picture[std::size_t{program.segments[i].region.y} * program.shape.width]);
  }
  return picture;
}

class ScanLineEngine final : public Engine {
 public:
  ScanLineEngine(ScanLineArray& hardware, machines::Machine machine)
      : hardware_(hardware), machine_(std::move(machine)) {}

  [[nodiscard]] std::string_view level() const override { return "cycle"; }

  RunResult run(const isa::Program& program, std::span<Observer* const> observers) override {
    machines::check_runs_on(program, machine_);
    const isa::Field colour = isa::field_of(program, isa::FieldRole::colour);
    Relay relay(program, observers);
    const scan_line::RunReport report = hardware_.run(
        {.lines = program.segments, .colour = colour, .background = program.compile.background, .listener = &relay});
    RunResult result;
    result.clocks = report.clocks;
    result.overflows = relay.overflows();
    result.account = report.account;
    if (colour.width > 0) result.scanned_out = picture_of(program, hardware_.lines());
    return result;
  }

 private:
  ScanLineArray& hardware_;
  machines::Machine machine_;
};

ScanLineArray& hardware_of(const machines::Machine& machine) {
  static const std::unique_ptr<ScanLineArray> hardware = std::make_unique<ScanLineArray>("scan_line", machine);
  return *hardware;
}

}  // namespace

std::unique_ptr<Engine> make_scan_line_engine(const machines::Machine& machine) {
  claim_elaboration(machine);
  return std::make_unique<ScanLineEngine>(hardware_of(machine), machine);
}

}  // namespace csgsim::sim
