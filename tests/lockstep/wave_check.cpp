#include "tests/lockstep/wave_check.h"

#include <fmt/format.h>
#include <rapidcheck.h>

#include <algorithm>
#include <optional>

#include "hw/isa/facts.h"
#include "hw/isa/instruction_numbers.h"
#include "hw/isa/opcodes.h"
#include "hw/machines/timeline.h"
#include "hw/wave/pixel_taps.h"
#include "tests/lockstep/lockstep.h"

namespace csgsim::test {

namespace {

constexpr std::uint64_t window_clocks = 400;
constexpr std::uint64_t before_and_after = 30;
constexpr std::uint32_t slice_bits = 29;

std::vector<isa::NamedField> slices(std::uint32_t memory_bits) {
  std::vector<isa::NamedField> fields;
  for (std::uint32_t base = 0; base < memory_bits; base += slice_bits)
    fields.push_back(
        {fmt::format("slice{}", base),
         {static_cast<std::uint16_t>(base), static_cast<std::uint16_t>(std::min(slice_bits, memory_bits - base))}});
  return fields;
}

/// Bits of a field that the instruction may change while it executes: the steps of a root write intermediate values to
/// its field.
std::uint64_t working_bits(const isa::Program& program, std::uint32_t segment, std::size_t index,
                           std::string_view name) {
  const isa::Instruction& instruction = program.segments[segment].instructions[index];
  if (instruction.opcode != isa::Opcode::root) return 0;
  const isa::Field& root = instruction.fields[0];
  std::uint64_t bits = 0;
  for (const isa::NamedField& slice : slices(program.shape.memory_bits)) {
    for (std::uint32_t bit = 0; slice.name == name && bit < slice.field.width; ++bit) {
      const std::uint32_t address = slice.field.base + bit;
      if (address >= root.base && address < root.end()) bits |= std::uint64_t{1} << bit;
    }
  }
  return bits;
}

std::uint32_t any_segment_with_instructions(const isa::Program& program) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t s = 0; s < program.segments.size(); ++s) {
    if (!program.segments[s].instructions.empty()) numbers.push_back(s);
  }
  return *rc::gen::elementOf(numbers);
}

}  // namespace

/// Records the pixel's states.
class WaveCheck::Watch final : public engine::Observer {
 public:
  explicit Watch(WaveCheck& check) : check_(check) {}

  void after_instruction(const engine::Step& step, const engine::PixelState& state) override {
    if (step.segment != check_.segment_) return;
    const isa::Region region = state.region();
    const std::uint32_t x = check_.pixel_.x - region.x;
    const std::uint32_t y = check_.pixel_.y - region.y;
    std::vector<std::uint32_t> values(std::size_t{region.width} * region.height);
    State now;
    for (const isa::NamedField& named : slices(check_.program_.shape.memory_bits)) {
      state.read_field(named.field, values);
      now[named.name] = values[std::size_t{y} * region.width + x];
    }
    const std::size_t row_words = (region.width + 63U) / 64U;
    std::vector<std::uint64_t> enable(row_words * region.height);
    state.read_enable(enable);
    now["enable"] = enable[y * row_words + x / 64] >> (x % 64) & 1U;
    check_.states_.push_back(std::move(now));
    check_.carried_out_.push_back(step.index);
  }

 private:
  WaveCheck& check_;
};

WaveCheck::WaveCheck(const isa::Program& program, const machines::Machine& machine, engine::Engine& judge)
    : program_(program), segment_(any_segment_with_instructions(program)) {
  const isa::Region& region = program.segments[segment_].region;
  pixel_ = {region.x + *rc::gen::inRange(0U, std::uint32_t{region.width}),
            region.y + *rc::gen::inRange(0U, std::uint32_t{region.height})};
  first_ = isa::first_instruction_numbers(program)[segment_];
  State zero{{"enable", 0}};
  for (isa::NamedField& named : slices(program.shape.memory_bits)) {
    zero[named.name] = 0;
    program_.facts->fields.push_back(std::move(named));
  }
  states_.push_back(std::move(zero));
  Watch watch(*this);
  engine::Observer* const observers[] = {&watch};
  const engine::RunResult run = judge.run(program, observers);
  const std::vector<machines::ClockSpan> spans = machines::spans_at_pixel(
      machines::timeline(program, machine, engine::run_outcome(run)), program, machine, segment_, pixel_.x, pixel_.y);
  for (const std::uint32_t index : carried_out_) spans_.push_back(spans[index]);
  const std::uint64_t earliest = spans_.front().begin - std::min(spans_.front().begin, before_and_after);
  window_.begin = *rc::gen::inRange(earliest, spans_.back().end + 1);
  window_.end = std::min(window_.begin + window_clocks, spans_.back().end + before_and_after);
}

void WaveCheck::check(const Vcd& wave, const std::string& top, std::uint64_t period_ps) const {
  const std::string part = top + "." + wave::pixel_part_name(pixel_) + ".";
  for (std::uint64_t clock = window_.begin; clock < window_.end; ++clock) {
    const std::uint64_t time = (clock + 1) * period_ps;
    if (time >= wave.last_time()) break;  // the frame is over
    check_clock(clock, [&](const std::string& name) { return wave.number_at(part + name, time); });
  }
}

void WaveCheck::check_clock(std::uint64_t clock, const Shown& shown) const {
  const auto require = [&](bool holds, const std::string& what) {
    if (holds) return;
    throw Difference(
        fmt::format("the wave of pixel {},{} (segment {}, of {} instructions from clock {} to {}), clock "
                    "{}: {}",
                    pixel_.x, pixel_.y, segment_, spans_.size(), spans_.front().begin, spans_.back().end, clock, what));
  };
  // The completed instructions, followed by the current one.
  const auto next = std::ranges::find_if(spans_, [clock](const machines::ClockSpan& span) { return span.end > clock; });
  const auto done = static_cast<std::size_t>(next - spans_.begin());
  const bool is_at_one = next != spans_.end() && next->begin <= clock;
  const std::optional<std::uint64_t> instruction = shown("instruction");
  require(instruction == (is_at_one ? std::optional(first_ + carried_out_[done]) : std::nullopt),
          fmt::format("it is not at instruction {} of these, as by the timeline", done));
  for (const auto& [name, before] : states_[done]) {
    const std::optional<std::uint64_t> value = shown(name);
    // The first packet of a chain may clear a cell with its first beat.
    const bool may_be_gone = clock <= spans_.front().begin || next == spans_.end();
    if (!value) {
      require(may_be_gone, name + " is not shown");
      continue;
    }
    const bool is_changing = is_at_one && next->begin < clock;
    const std::uint64_t free_bits =
        is_changing ? (before ^ states_[done + 1].at(name)) | working_bits(program_, segment_, carried_out_[done], name)
                    : 0;
    require(((*value ^ before) & ~free_bits) == 0,
            fmt::format("{} is {:#x}, not {:#x} after {} instructions", name, *value, before, done));
  }
}

}  // namespace csgsim::test
