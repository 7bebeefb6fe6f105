#include "sim/waves/window.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "hw/array/pixel_replay.h"
#include "hw/base/error.h"
#include "hw/base/nearest.h"
#include "hw/isa/facts.h"
#include "hw/isa/instruction_numbers.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/isa/pieces.h"
#include "hw/wave/instruction_taps.h"

namespace csgsim::waves {

namespace {

constexpr std::uint64_t small_gap = 16;          // clocks; stretches closer than this are joined
constexpr std::uint64_t max_clocks_before = 40;  // clocks recorded before an instruction reaches the pixel
constexpr std::string_view forms =
    "clocks FIRST:END, instructions iFIRST:iEND or iN, primitive:NAME, purpose:NAME or effect:NAME";

[[noreturn]] void fail(std::string_view text) {
  throw InputError(fmt::format("'{}' is not a window; use {}", text, forms));
}

std::optional<std::uint64_t> number_of(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Parses a number, preceded by `i` if it is an instruction number.
std::optional<std::uint64_t> end_of_range(std::string_view text, bool is_instruction) {
  if (!is_instruction) return number_of(text);
  if (text.empty() || text.front() != 'i') return std::nullopt;
  return number_of(text.substr(1));
}

WindowRequest range_of(std::string_view text) {
  const bool counts_instructions = !text.empty() && text.front() == 'i';
  const std::size_t colon = text.find(':');
  const auto first = end_of_range(text.substr(0, colon), counts_instructions);
  if (!first || (colon == std::string_view::npos && !counts_instructions)) fail(text);
  const auto end = colon == std::string_view::npos ? std::optional(*first + 1)
                                                   : end_of_range(text.substr(colon + 1), counts_instructions);
  if (!end) fail(text);
  if (*end <= *first) throw InputError(fmt::format("the window '{}' is empty; END must be greater than FIRST", text));
  using Kind = WindowRequest::Kind;
  return {counts_instructions ? Kind::instructions : Kind::clocks, *first, *end, ""};
}

constexpr auto named_kinds =
    std::to_array<std::pair<std::string_view, WindowRequest::Kind>>({{"primitive:", WindowRequest::Kind::primitive},
                                                                     {"purpose:", WindowRequest::Kind::purpose},
                                                                     {"effect:", WindowRequest::Kind::effect}});

/// The index of a name. Throws InputError with the nearest name.
std::size_t index_of(std::string_view what, std::string_view name, std::span<const std::string_view> names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  throw InputError("in the Program " + unknown_name_text(what, name, names));
}

using Belongs = std::function<bool(const isa::Instruction&)>;

Belongs belongs_to(const WindowRequest& request, const isa::Program& program) {
  if (request.kind == WindowRequest::Kind::primitive) {
    const isa::PieceRange pieces = isa::pieces_of(*program.facts, static_cast<std::uint32_t>(request.begin));
    return [pieces](const isa::Instruction& one) {
      const std::uint32_t piece = one.origin.primitive;
      return piece >= pieces.first && piece - pieces.first < pieces.count;
    };
  }
  if (request.kind == WindowRequest::Kind::purpose) {
    std::vector<std::string_view> names;
    names.reserve(std::size(isa::purpose_table));
    for (const isa::PurposeInfo& row : isa::purpose_table) names.push_back(row.name);
    return [index = index_of("purpose", request.name, names)](const isa::Instruction& one) {
      return static_cast<std::size_t>(one.origin.purpose) == index;
    };
  }
  const std::vector<std::string>& effects = program.facts->compile.effects;
  return [index = index_of("effect", request.name, std::vector<std::string_view>(effects.begin(), effects.end()))](
             const isa::Instruction& one) { return one.origin.effect == index; };
}

/// Collects the clocks of instructions.
class Stretches {
 public:
  Stretches(const isa::Program& program, const machines::Machine& machine, const Foreknowledge& known,
            std::span<const wave::Pixel> pixels)
      : program_(program), machine_(machine), known_(known), pixels_(pixels) {}

  /// Adds the instructions of a segment for which `belongs` returns true, given number and instruction.
  void add(std::uint32_t segment, const std::function<bool(std::uint64_t, const isa::Instruction&)>& belongs) {
    const std::vector<isa::Instruction>& all = program_.segments[segment].instructions;
    const std::uint64_t first = isa::first_instruction_numbers(program_)[segment];
    std::vector<std::vector<machines::ClockSpan>> at_pixels;
    for (const wave::Pixel pixel : pixels_) {
      if (program_.segments[segment].region.holds(pixel.x, pixel.y))
        at_pixels.push_back(machines::spans_at_pixel(known_.timeline, program_, machine_, segment, pixel.x, pixel.y));
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      const machines::ClockSpan issued = known_.timeline.issued[segment][i];
      if (issued.empty() || !belongs(first + i, all[i])) continue;
      std::uint64_t end = issued.end;
      for (const auto& spans : at_pixels) end = std::max(end, spans[i].end);
      windows_.push_back({issued.begin, end + 1});
    }
  }

  [[nodiscard]] bool holds_pixel(std::uint32_t segment) const {
    return std::any_of(pixels_.begin(), pixels_.end(),
                       [&](wave::Pixel pixel) { return program_.segments[segment].region.holds(pixel.x, pixel.y); });
  }

  [[nodiscard]] std::vector<wave::Window> joined() && {
    std::sort(windows_.begin(), windows_.end(),
              [](const wave::Window& one, const wave::Window& other) { return one.begin < other.begin; });
    std::vector<wave::Window> result;
    for (const wave::Window& one : windows_) {
      if (!result.empty() && one.begin <= result.back().end + small_gap) {
        result.back().end = std::max(result.back().end, one.end);
      } else {
        result.push_back(one);
      }
    }
    return result;
  }

 private:
  const isa::Program& program_;
  const machines::Machine& machine_;
  const Foreknowledge& known_;
  std::span<const wave::Pixel> pixels_;
  std::vector<wave::Window> windows_;
};

isa::Field field_named(std::string_view target, const isa::Program& program) {
  const bool is_colour = target == "owner" || target == "colour";
  if (is_colour || target == "depth") {
    const isa::Field field = is_colour ? program.colour : isa::find_field(program, isa::FieldRole::depth);
    if (field.width > 0) return field;
    throw InputError(
        fmt::format("the Program has no field for the {}; name another field", is_colour ? "colour" : "depth"));
  }
  std::vector<std::string_view> names;
  for (const isa::NamedField& named : program.facts->fields) names.push_back(named.name);
  return program.facts->fields[index_of("field", target, names)].field;
}

}  // namespace

WindowRequest parse_window(std::string_view text) {
  for (const auto& [beginning, kind] : named_kinds) {
    if (text.substr(0, beginning.size()) != beginning) continue;
    if (text.size() == beginning.size()) fail(text);
    return {kind, 0, 0, std::string(text.substr(beginning.size()))};
  }
  return range_of(text);
}

std::vector<wave::Window> find_windows(const WindowRequest& request, const isa::Program& program,
                                       const machines::Machine& machine, const Foreknowledge& known,
                                       std::span<const wave::Pixel> pixels) {
  using Kind = WindowRequest::Kind;
  if (request.kind == Kind::clocks) return {{request.begin, request.end}};
  Stretches stretches(program, machine, known, pixels);
  const bool by_number = request.kind == Kind::instructions;
  const Belongs belongs = by_number ? Belongs() : belongs_to(request, program);
  for (std::uint32_t s = 0; s < program.segments.size(); ++s) {
    if (!by_number && !stretches.holds_pixel(s)) continue;
    stretches.add(s, [&](std::uint64_t number, const isa::Instruction& instruction) {
      return by_number ? number >= request.begin && number < request.end : belongs(instruction);
    });
  }
  std::vector<wave::Window> windows = std::move(stretches).joined();
  if (windows.empty()) {
    throw InputError(
        by_number
            ? fmt::format("none of the instructions i{} to i{} is executed; the Program has {} instructions",
                          request.begin, request.end - 1, isa::first_instruction_numbers(program).back())
            : fmt::format("no instruction of {} is executed at the probed pixels; choose other pixels", request.name));
  }
  return windows;
}

std::vector<wave::Window> pad_windows(std::span<const wave::Window> windows, std::uint64_t clocks) {
  std::vector<wave::Window> all;
  for (const wave::Window& window : windows) {
    const wave::Window one{window.begin - std::min(window.begin, clocks), window.end + std::min(~window.end, clocks)};
    if (!all.empty() && one.begin <= all.back().end) {
      all.back().end = one.end;
    } else {
      all.push_back(one);
    }
  }
  return all;
}

LastWrite last_write(std::string_view target, const isa::Program& program, const machines::Machine& machine,
                     const Foreknowledge& known, wave::Pixel pixel) {
  const isa::Field field = field_named(target, program);
  LastWrite last;
  bool is_found = false;
  std::size_t questions = 0;
  for (std::uint32_t s = 0; s < program.segments.size(); ++s) {
    const isa::Segment& segment = program.segments[s];
    const bool is_here = segment.region.holds(pixel.x, pixel.y);
    const array::Place place{pixel.x - segment.region.x, pixel.y - segment.region.y};
    array::PixelReplay replay({&place, 1}, program.shape.memory_bits,
                              array::Sequencer(machine.memory_reads, machine.alu_bits, machine.evaluator_bits),
                              machine.alu_bits);
    replay.begin(segment.region);
    for (std::uint32_t i = 0; i < segment.instructions.size(); ++i) {
      const isa::Instruction& instruction = segment.instructions[i];
      if (is_here) {
        const std::uint64_t before = replay.pixels().value(field, 0, 0);
        replay.execute(instruction);
        if (isa::may_write(instruction, field) && replay.pixels().value(field, 0, 0) != before) {
          is_found = true;
          last.segment = s;
          last.index = i;
        }
      }
      if (isa::needs_global_or(instruction.opcode))
        i += static_cast<std::uint32_t>(
            isa::skipped_instruction_count(instruction, known.answers.at(questions++) ? 1 : 0));
    }
  }
  if (!is_found) {
    throw InputError(fmt::format("no instruction changes the {} of pixel {},{}; choose another --pixel or --at", target,
                                 pixel.x, pixel.y));
  }
  last.number = isa::first_instruction_numbers(program)[last.segment] + last.index;
  last.at_pixel =
      machines::spans_at_pixel(known.timeline, program, machine, last.segment, pixel.x, pixel.y)[last.index];
  const std::uint64_t issued = known.timeline.issued[last.segment][last.index].begin;
  const std::uint64_t way = last.at_pixel.begin - std::min(issued, last.at_pixel.begin);
  last.windows = {{last.at_pixel.begin - std::min(way, max_clocks_before), last.at_pixel.end + 1}};
  return last;
}

}  // namespace csgsim::waves
