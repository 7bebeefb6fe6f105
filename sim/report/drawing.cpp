#include "sim/report/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "hw/base/text.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/facts.h"
#include "hw/isa/pieces.h"
#include "hw/isa/text.h"
#include "sim/engine/engine.h"
#include "sim/engine/numbers.h"
#include "sim/engine/run.h"
#include "sim/report/codec.h"

namespace csgsim::report {

namespace {

using States = std::vector<std::uint32_t>;

/// Counts the clocks of a run and keeps its last instruction. It reads each region at its end, since several regions
/// may end between two steps.
class Progress : public engine::Observer {
 public:
  explicit Progress(std::function<void(std::uint32_t, const engine::PixelState&)> look) : look_(std::move(look)) {}

  [[nodiscard]] bool reads_after(const isa::Instruction& /*instruction*/) const override { return false; }
  void after_instruction(const engine::Step& step, const engine::PixelState& /*state*/) override {
    clocks_ += step.clocks;
    last_ = step.instruction;
  }
  void after_segment(std::uint32_t segment, const engine::PixelState& state) override { look_(segment, state); }
  [[nodiscard]] std::uint64_t clocks() const { return clocks_; }
  [[nodiscard]] const std::optional<isa::Instruction>& last() const { return last_; }

 private:
  std::function<void(std::uint32_t, const engine::PixelState&)> look_;
  std::uint64_t clocks_ = 0;
  std::optional<isa::Instruction> last_;
};

/// Numbers of the instruction boundaries where the origin changes, and of the ends of regions.
std::vector<std::uint64_t> boundaries_of_work(const isa::Program& program) {
  std::vector<std::uint64_t> boundaries;
  std::uint64_t number = 0;
  for (const isa::Segment& segment : program.segments) {
    for (std::size_t i = 0; i < segment.instructions.size(); ++i) {
      ++number;
      const bool is_last = i + 1 == segment.instructions.size();
      if (is_last || segment.instructions[i].origin != segment.instructions[i + 1].origin) boundaries.push_back(number);
    }
  }
  return boundaries;
}

/// Keeps every second boundary and the last one.
void keep_every_second(std::vector<std::uint64_t>& boundaries) {
  std::size_t place = 0;
  const std::size_t count = boundaries.size();
  std::erase_if(boundaries, [&](std::uint64_t /*boundary*/) { return place++ % 2 == 0 && place != count; });
}

class Recorder {
 public:
  Recorder(const isa::Program& program, const machines::Machine& machine, const DrawingLimits& limits)
      : program_(program),
        run_(engine::make_functional_engine(machine)->begin(program)),
        numbers_(program),
        colour_(program.colour),
        progress_([this](std::uint32_t segment, const engine::PixelState& state) { look(segment, state); }) {
    drawing_.every =
        std::max(1U, (std::max(program.shape.width, program.shape.height) + limits.side - 1) / limits.side);
    drawing_.width = (program.shape.width + drawing_.every - 1) / drawing_.every;
    drawing_.height = (program.shape.height + drawing_.every - 1) / drawing_.every;
    states_.assign(std::size_t{drawing_.width} * drawing_.height, 0);
    const States nothing = states_;
    std::fill(states_.begin(), states_.end(), state(program.background, false));
    kept_ = states_;
    add({0, "", "nothing yet: the background", 0, 0, encode_changes(nothing, states_)});
  }

  /// Advances to that boundary, or past it if instructions are skipped, and adds a step unless the run is already
  /// there.
  void go_to(std::uint64_t boundary) {
    if (numbers_.of(run_->place()) >= boundary) return;
    engine::Observer* const observers[] = {&progress_};
    run_->advance(boundary, observers);
    DrawingStep step{numbers_.of(run_->place()), "", "", progress_.clocks(), look(run_->place().segment, *run_), ""};
    if (progress_.last()) {
      step.text = isa::text_of(*progress_.last(), program_.facts->fields);
      step.serves = purpose_text(*progress_.last(), *program_.facts);
    }
    step.changes = encode_changes(kept_, states_);
    kept_ = states_;
    add(std::move(step));
  }

  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::size_t steps() const { return drawing_.steps.size(); }

  /// Removes every second step; the last one stays if it is the end of the run.
  void thin(bool at_end) {
    std::vector<DrawingStep> all = std::exchange(drawing_.steps, {});
    bytes_ = 0;
    const States nothing(states_.size(), 0);
    States difference = nothing;
    for (std::size_t i = 0; i < all.size(); ++i) {
      apply_changes(all[i].changes, difference);
      if (i % 2 != 0 && !(at_end && i + 1 == all.size())) continue;
      all[i].changes = encode_changes(nothing, difference);
      difference = nothing;
      add(std::move(all[i]));
    }
    for (std::size_t i = 0; i < kept_.size(); ++i) kept_[i] ^= difference[i];
  }

  [[nodiscard]] Drawing take() { return std::move(drawing_); }

 private:
  [[nodiscard]] std::uint32_t state(std::uint32_t packed, bool enabled) const {
    const auto [red, green, blue] = isa::unpack_colour(packed, colour_.width);
    return (std::uint32_t{red} << 16U | std::uint32_t{green} << 8U | blue) << 1U | (enabled ? 1U : 0U);
  }

  void add(DrawingStep step) {
    constexpr std::size_t punctuation = 40;  // bytes of a JSON array with six elements, including its numbers
    bytes_ += step.text.size() + step.serves.size() + (step.changes.size() + 2) / 3 * 4 + punctuation;
    drawing_.steps.push_back(std::move(step));
  }

  /// Calls visit(state of the picture, x, y in the region) for the displayed pixels of the region.
  template <class Visit>
  void visit_shown(const isa::Region& region, Visit visit) {
    const std::uint32_t every = drawing_.every;
    const auto first = [&](std::uint32_t from) { return (every - from % every) % every; };
    for (std::uint32_t y = first(region.y); y < region.height; y += every) {
      const std::size_t row = std::size_t{(region.y + y) / every} * drawing_.width;
      for (std::uint32_t x = first(region.x); x < region.width; x += every)
        visit(states_[row + (region.x + x) / every], x, y);
    }
  }

  /// Updates the states, and returns the number of enabled pixels.
  std::uint64_t look(std::uint32_t segment, const engine::PixelState& pixels) {
    if (program_.segments[segment].instructions.empty()) return 0;  // shows the background
    const isa::Region region = pixels.region();
    if (region != region_) visit_shown(region_, [](std::uint32_t& state, auto, auto) { state &= ~1U; });
    region_ = region;
    const std::size_t words = (region.width + 63U) / 64U;
    enable_.assign(words * region.height, 0);
    pixels.read_enable(enable_);
    colours_.assign(std::size_t{region.width} * region.height, 0);
    if (colour_.width > 0) pixels.read_field(colour_, colours_);
    visit_shown(region, [&](std::uint32_t& pixel, std::uint32_t x, std::uint32_t y) {
      const bool enabled = (enable_[y * words + x / 64U] >> (x % 64U) & 1U) != 0;
      pixel = state(colours_[std::size_t{y} * region.width + x], enabled);
    });
    std::uint64_t enabled = 0;
    for (const std::uint64_t word : enable_) enabled += static_cast<std::uint64_t>(std::popcount(word));
    return enabled;
  }

  const isa::Program& program_;
  std::unique_ptr<engine::Run> run_;
  engine::Numbers numbers_;
  isa::Field colour_;
  Progress progress_;
  isa::Region region_{};
  States states_;
  States kept_;  ///< states at the last step
  std::vector<std::uint64_t> enable_;
  std::vector<std::uint32_t> colours_;
  Drawing drawing_;
  std::size_t bytes_ = 0;
};

/// Records a step after every instruction; nothing if the steps exceed the limits.
std::optional<Drawing> record_every(const isa::Program& program, const machines::Machine& machine,
                                    const DrawingLimits& limits, std::uint64_t count) {
  Recorder recorder(program, machine, limits);
  for (std::uint64_t boundary = 1; boundary <= count; ++boundary) {
    recorder.go_to(boundary);
    if (recorder.bytes() > limits.bytes) return std::nullopt;
  }
  Drawing drawing = recorder.take();
  drawing.summary = fmt::format("There is a step after each of the {} instructions.", grouped(count));
  return drawing;
}

std::string work_summary(std::uint64_t count, std::size_t found, std::size_t kept_every, const DrawingLimits& limits) {
  const std::string why = count > limits.instructions
                              ? fmt::format("Programs of at most {} instructions have a step after each of them",
                                            grouped(limits.instructions))
                              : fmt::format(
                                    "Programs whose steps fill at most {} bytes have a step after each "
                                    "instruction",
                                    grouped(limits.bytes));
  std::string summary = fmt::format(
      "{}. This run has {} instructions: there is a step wherever their purpose or primitive changes, {} in "
      "all.",
      why, grouped(count), grouped(found));
  if (kept_every > 1)
    summary += fmt::format(" One in {} of these is kept, to limit them to {} steps and {} bytes.", kept_every,
                           grouped(limits.steps), grouped(limits.bytes));
  return summary;
}

Drawing record_work(const isa::Program& program, const machines::Machine& machine, const DrawingLimits& limits,
                    std::uint64_t count) {
  std::vector<std::uint64_t> boundaries = boundaries_of_work(program);
  const std::size_t found = boundaries.size();
  std::size_t kept_every = 1;
  for (; boundaries.size() > limits.steps; kept_every *= 2) keep_every_second(boundaries);
  Recorder recorder(program, machine, limits);
  std::size_t stride = 1;  // boundaries per step
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    const bool is_last = i + 1 == boundaries.size();
    if ((i + 1) % stride == 0 || is_last) recorder.go_to(boundaries[i]);
    for (; recorder.bytes() > limits.bytes && recorder.steps() > 2; stride *= 2) recorder.thin(is_last);
  }
  Drawing drawing = recorder.take();
  drawing.summary = work_summary(count, found, kept_every * stride, limits);
  return drawing;
}

}  // namespace

std::string purpose_text(const isa::Instruction& instruction, const isa::Facts& facts) {
  const isa::Origin& origin = instruction.origin;
  std::string text(isa::info(origin.purpose).name);
  if (origin.primitive != isa::no_primitive) text += " " + isa::piece_name(facts, origin.primitive);
  if (origin.node != isa::no_node) text += " against " + isa::piece_name(facts, origin.node);
  return text;
}

std::size_t step_after(std::span<const DrawingStep> steps, std::uint64_t instructions) {
  const auto found =
      std::find_if(steps.begin(), steps.end(), [&](const DrawingStep& step) { return step.number >= instructions; });
  return std::min(static_cast<std::size_t>(found - steps.begin()), steps.size() - 1);
}

Drawing record_drawing(const isa::Program& program, const machines::Machine& machine, const DrawingLimits& limits) {
  const std::uint64_t count = engine::Numbers(program).count();
  std::optional<Drawing> drawing;
  if (count <= std::min<std::uint64_t>(limits.instructions, limits.steps))
    drawing = record_every(program, machine, limits, count);
  if (!drawing) drawing = record_work(program, machine, limits, count);
  if (drawing->every > 1)
    drawing->summary +=
        fmt::format(" One pixel in {} of each row, and one row in {}, is shown.", drawing->every, drawing->every);
  return std::move(*drawing);
}

}  // namespace csgsim::report
