#include "hw/pixel_planes/taps.h"

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

#include "hw/base/error.h"
#include "hw/wave/instruction_taps.h"
#include "hw/wave/pixel_taps.h"

namespace csgsim::pixel_planes {

namespace {

using wave::Number;
using wave::Tap;

constexpr unsigned address_bits = 12;  // enough for isa::max_memory_bits

std::string function_of(const ControlWord& word) {
  if (word.clears) return "clear";
  if (word.refreshes) return "refresh";
  std::string names;
  for (const array::AluFunction function : {word.step.function, word.step.beyond, word.step.sign}) {
    if (function == array::AluFunction::idle) continue;
    names += names.empty() ? "" : "+";
    names += array::info(function).name;
  }
  return names;
}

/// Reads the signals of one pixel for its taps.
class Probe {
 public:
  explicit Probe(PixelPoint point) : point_(std::move(point)) {}

  [[nodiscard]] bool shows() const { return !point_.shows || point_.shows(); }
  [[nodiscard]] array::PixelProbe registers() const { return point_.pipeline.probe(point_.built.x, point_.built.y); }
  [[nodiscard]] array::LevelProbe level(wave::TreeLevel level) const {
    return level.axis == wave::TreeLevel::Axis::x ? point_.pipeline.now().x_level(level.level, point_.place)
                                                  : point_.pipeline.now().y_level(level.level, point_.place);
  }

  /// A field of memory, truncated at the end of memory: a wide ALU may read beyond it for a narrow operand.
  [[nodiscard]] std::uint64_t memory(isa::Field field) const {
    const std::uint32_t left = point_.pipeline.pixels().memory_bits() - field.base;
    field.width = static_cast<std::uint16_t>(std::min<std::uint32_t>(field.width, left));
    return point_.pipeline.pixels().value(field, point_.built.x, point_.built.y);
  }

  /// Data of the first read port.
  [[nodiscard]] Number read_x() const {
    const array::ArrayStep& step = point_.pipeline.now().at_pixels().step;
    const bool is_read = array::info(step.function).reads_x && step.source == array::OperandSource::memory;
    return is_read ? Number(memory({step.x, step.bits})) : std::nullopt;
  }
  /// Data of the second read port; if operand x does not come from memory, of the only port in use.
  [[nodiscard]] Number read_y() const {
    const array::ArrayStep& step = point_.pipeline.now().at_pixels().step;
    return array::info(step.function).reads_y ? Number(memory({step.y, step.bits})) : std::nullopt;
  }
  /// Content of memory after the previous step, at the address that the step may have written.
  [[nodiscard]] Number written() const {
    const array::ArrayStep& step = point_.pipeline.now().last_executed().step;
    return array::info(step.function).writes ? Number(memory({step.write, step.bits})) : std::nullopt;
  }

 private:
  PixelPoint point_;
};

}  // namespace

std::vector<Tap> root_taps(const std::string& part, const PixelPipeline& pipeline, array::TreeForm trees) {
  const auto reading = [&pipeline](auto read) {
    return [&pipeline, read] {
      const array::RootBits& bits = pipeline.now().roots();
      return bits.token.active() ? Number(read(bits)) : std::nullopt;
    };
  };
  const auto tap = [&](const char* name, std::uint32_t array::RootBits::*member) {
    return wave::bits(part + name, trees.bits, reading([member](const array::RootBits& bits) { return bits.*member; }));
  };
  std::vector<Tap> taps{
      wave::text(part + ".state",
                 [&pipeline] { return std::string(pipeline.now().roots().token.active() ? "streaming" : ""); }),
      tap(".a", &array::RootBits::a), tap(".b", &array::RootBits::b), tap(".c", &array::RootBits::c),
      wave::number(part + ".bit", 8,
                   reading([](const array::RootBits& bits) { return static_cast<std::uint64_t>(bits.token.bit); }))};
  if (trees.bits > 1)
    taps.push_back(wave::number(part + ".bits", 6,
                                reading([](const array::RootBits& bits) { return std::uint64_t{bits.token.bits}; })));
  if (trees.degree < 2) return taps;
  taps.push_back(tap(".xx", &array::RootBits::xx));
  taps.push_back(tap(".xy", &array::RootBits::xy));
  taps.push_back(tap(".yy", &array::RootBits::yy));
  return taps;
}

std::vector<Tap> control_taps(const std::string& part, const PixelPipeline& pipeline, unsigned tree_bits,
                              const isa::Program& program, std::function<Number()> at) {
  std::vector<Tap> taps = wave::instruction_taps(part, program, [&pipeline, at = std::move(at)] {
    return pipeline.now().at_pixels().steps ? at() : std::nullopt;
  });
  taps.push_back(wave::text(part + ".function", [&pipeline] { return function_of(pipeline.now().at_pixels()); }));
  const auto address = [&](const char* name, auto has, auto read) {
    taps.push_back(wave::number(part + name, address_bits, [&pipeline, has, read] {
      const array::ArrayStep& step = pipeline.now().at_pixels().step;
      return has(step) ? Number(read(step)) : std::nullopt;
    }));
  };
  using Step = array::ArrayStep;
  address(
      ".read_x",
      [](const Step& step) {
        return array::info(step.function).reads_x && step.source == array::OperandSource::memory;
      },
      [](const Step& step) { return step.x; });
  address(
      ".read_y", [](const Step& step) { return array::info(step.function).reads_y; },
      [](const Step& step) { return step.y; });
  address(
      ".write", [](const Step& step) { return array::info(step.function).writes; },
      [](const Step& step) { return step.write; });
  taps.push_back(wave::number(part + ".bits", 6, [&pipeline] {
    const Step& step = pipeline.now().at_pixels().step;
    return step.function == array::AluFunction::idle ? std::nullopt : Number(step.bits);
  }));
  if (tree_bits > 1) {
    taps.push_back(wave::number(part + ".first", 6, [&pipeline] {
      const Step& step = pipeline.now().at_pixels().step;
      const bool takes = step.source == array::OperandSource::tree && array::info(step.function).reads_x;
      return takes ? Number(step.first) : std::nullopt;
    }));
  }
  taps.push_back(wave::hexadecimal(part + ".constant", 32,
                                   [&pipeline]() -> Number { return pipeline.now().at_pixels().step.constant; }));
  return taps;
}

std::vector<Tap> pixel_taps(wave::Pixel pixel, PixelPoint point, const isa::Program& program,
                            std::span<const wave::TreeLevel> levels, unsigned alu_bits) {
  const std::string part = wave::pixel_part_name(pixel);
  for (const wave::TreeLevel level : levels) {
    const bool is_x = level.axis == wave::TreeLevel::Axis::x;
    const unsigned deepest = is_x ? point.pipeline.now().x_levels() : point.pipeline.now().y_levels();
    if (level.level > deepest)
      throw InputError(std::string("the ") + (is_x ? "X" : "Y") + " tree has levels 0 to " + std::to_string(deepest) +
                       "; tree." + (is_x ? "x:" : "y:") + std::to_string(level.level) + " does not exist");
  }
  const array::TreeForm trees = point.trees;
  const auto probe = std::make_shared<const Probe>(std::move(point));
  const auto shown = [probe](auto read) {
    return [probe, read]() -> Number { return probe->shows() ? Number(read(*probe)) : std::nullopt; };
  };
  std::vector<Tap> taps;
  for (const wave::TreeLevel level : levels) {
    const std::string name =
        part + (level.axis == wave::TreeLevel::Axis::x ? ".tree_x_" : ".tree_y_") + std::to_string(level.level);
    const auto read = [shown, level](auto member) {
      return shown([level, member](const Probe& one) -> Number {
        const array::LevelProbe at = one.level(level);
        return at.token.active() ? member(at) : std::nullopt;
      });
    };
    const auto stream = [&](const std::string& of, std::uint32_t array::LevelProbe::*member) {
      taps.push_back(
          wave::bits(of, trees.bits, read([member](const array::LevelProbe& at) -> Number { return at.*member; })));
    };
    stream(name, &array::LevelProbe::stream);
    taps.push_back(wave::bit(name + "_carry", read([](const array::LevelProbe& at) -> Number { return at.carry; })));
    taps.push_back(wave::number(name + "_bit", 8, read([](const array::LevelProbe& at) -> Number {
                                  return static_cast<std::uint64_t>(at.token.bit);
                                })));
    if (trees.degree < 2) continue;
    const auto bit = [&](const char* of, bool array::LevelProbe::*member) {
      taps.push_back(
          wave::bit(name + of, read([member](const array::LevelProbe& at) -> Number { return at.*member; })));
    };
    stream(name + "_slope", &array::LevelProbe::slope);
    bit("_slope_carry", &array::LevelProbe::slope_carry);
    bit("_step_carry", &array::LevelProbe::step_carry);
    if (level.axis != wave::TreeLevel::Axis::x) continue;
    stream(name + "_row_slope", &array::LevelProbe::row_slope);
    bit("_row_slope_carry", &array::LevelProbe::row_slope_carry);
  }
  taps.push_back(
      wave::bits(part + ".tree_bit", trees.bits, shown([](const Probe& one) { return one.registers().tree; })));
  taps.push_back(wave::bit(part + ".carry", shown([](const Probe& one) { return one.registers().carry; })));
  taps.push_back(wave::bit(part + ".flag", shown([](const Probe& one) { return one.registers().flag; })));
  taps.push_back(wave::bit(part + ".enable", shown([](const Probe& one) { return one.registers().enable; })));
  taps.push_back(wave::bits(part + ".latch", alu_bits, shown([](const Probe& one) { return one.registers().latch; })));
  taps.push_back(wave::bits(part + ".mem_read_x", alu_bits, shown([](const Probe& one) { return one.read_x(); })));
  taps.push_back(wave::bits(part + ".mem_read_y", alu_bits, shown([](const Probe& one) { return one.read_y(); })));
  taps.push_back(wave::bits(part + ".mem_written", alu_bits, shown([](const Probe& one) { return one.written(); })));
  const auto field = [probe](isa::Field at) { return probe->shows() ? Number(probe->memory(at)) : std::nullopt; };
  for (Tap& tap : wave::field_taps(part, program, field)) taps.push_back(std::move(tap));
  return taps;
}

}  // namespace csgsim::pixel_planes
