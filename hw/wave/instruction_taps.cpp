#include "hw/wave/instruction_taps.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

#include "hw/isa/facts.h"
#include "hw/isa/instruction_numbers.h"
#include "hw/isa/pieces.h"
#include "hw/isa/text.h"

namespace csgsim::wave {

namespace {

/// Texts of the current instruction. Its disassembly is cached while the instruction stays the same.
class Words {
 public:
  Words(const isa::Program& program, std::function<Number()> at)
      : program_(program), at_(std::move(at)), begins_(isa::first_instruction_numbers(program)) {}

  [[nodiscard]] Number number() const { return at_(); }

  /// Null if there is no instruction.
  [[nodiscard]] const isa::Instruction* instruction() const {
    const Number number = at_();
    if (!number) return nullptr;
    const auto after = std::upper_bound(begins_.begin(), begins_.end(), *number);
    if (after == begins_.begin()) return nullptr;
    const isa::Segment& segment = program_.segments[static_cast<std::size_t>(after - begins_.begin()) - 1];
    const std::uint64_t index = *number - *std::prev(after);
    return index < segment.instructions.size() ? &segment.instructions[index] : nullptr;
  }

  [[nodiscard]] const std::string& text() {
    const isa::Instruction* const one = instruction();
    if (std::exchange(shown_, one) != one) text_ = one == nullptr ? "" : isa::text_of(*one, program_.facts->fields);
    return text_;
  }

  [[nodiscard]] std::string primitive(std::uint32_t index) const {
    return index == isa::no_primitive ? "" : isa::piece_name(*program_.facts, index);
  }

  [[nodiscard]] std::string effect(std::uint8_t index) const {
    const std::vector<std::string>& names = program_.facts->compile.effects;
    return index < names.size() ? names[index] : "";
  }

 private:
  const isa::Program& program_;
  std::function<Number()> at_;
  std::vector<std::uint64_t> begins_;
  const isa::Instruction* shown_ = nullptr;
  std::string text_;
};

}  // namespace

std::vector<Tap> instruction_taps(const std::string& part, const isa::Program& program,
                                  std::function<Number()> current) {
  const auto words = std::make_shared<Words>(program, std::move(current));
  const auto of_origin = [&](const char* name, auto read) {
    return text(part + name, [words, read] {
      const isa::Instruction* const one = words->instruction();
      return one == nullptr ? std::string() : std::string(read(*words, one->origin));
    });
  };
  return {
      number(part + ".instruction", 32, [words] { return words->number(); }),
      text(part + ".text", [words] { return words->text(); }),
      of_origin(".purpose", [](const Words&, const isa::Origin& origin) { return isa::info(origin.purpose).name; }),
      of_origin(".primitive",
                [](const Words& known, const isa::Origin& origin) { return known.primitive(origin.primitive); }),
      of_origin(".against", [](const Words& known, const isa::Origin& origin) { return known.primitive(origin.node); }),
      of_origin(".effect", [](const Words& known, const isa::Origin& origin) { return known.effect(origin.effect); })};
}

}  // namespace csgsim::wave
