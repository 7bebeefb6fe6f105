#pragma once

#include <any>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hw/isa/link_word.h"
#include "hw/isa/program.h"
#include "hw/machines/host.h"

namespace csgsim::machines {

class Kind;

/// One figure of a machine description, with where it comes from.
struct Figure {
  std::string key;         ///< as in the file, for instance `array.width`
  std::string value;       ///< as text; `ideal` where it stands for no limit of any hardware
  std::string unit;        ///< may be empty
  std::string provenance;  ///< `published` or `assumed`
  std::string source;      ///< the publication, or why it is assumed so
};

/// Width and height of a picture, pixels.
struct Size {
  std::uint32_t width = 0;
  std::uint32_t height = 0;

  constexpr bool operator==(const Size&) const = default;
};

/// How instructions come to a machine: words of a link, into a FIFO at its end (hw/isa/wire.h says what is in them).
struct Link {
  std::uint32_t width = isa::LinkWord::most_bits;  ///< bits of a word
  std::uint32_t word_clocks = 1;                   ///< from one word to the next
  std::uint32_t fifo_depth = 16;                   ///< words
  std::uint32_t latency = 0;  ///< clocks from a request, of the frame's beginning or of a jump, to the first word

  constexpr bool operator==(const Link&) const = default;
};

/// A logic-enhanced frame buffer, as its description in hw/machines/NAME.toml says.
struct Machine {
  std::string name;
  std::string description;
  const Kind* kind = nullptr;          ///< what its processors are spread over at a time
  isa::ArrayShape array;               ///< pixel processors (of one chain, of one renderer) and memory bits of each
  Size picture;                        ///< that the machine draws
  std::uint64_t clock_hz = 0;          ///< instruction bit steps, or packets, a second
  std::uint32_t memory_reads = 1;      ///< reads of pixel memory a clock: 1 or 2
  std::uint32_t evaluator_degree = 1;  ///< of the expressions that reach the pixels: 1 or 2
  std::uint32_t register_levels = 1;   ///< of the trees, from one register to the next
  std::uint32_t evaluator_bits = 1;    ///< of an expression that reach the pixels in a clock: at most alu_bits
  std::uint32_t alu_bits = 1;      ///< adjacent bits of a field that the ALU works on, and a port delivers, in a clock
  std::uint32_t clear_clocks = 0;  ///< in which all memory of the pixel processors becomes 0
  Link link;
  Host host;
  std::any own;                 ///< what only its kind has; see own<Figures>()
  std::vector<Figure> figures;  ///< every figure of the file, in its order
};

/// The figures that only the machine's kind has, of the type that the kind gives them. Throws std::bad_any_cast for a
/// machine of another kind.
template <class Figures>
const Figures& own(const Machine& machine) {
  return std::any_cast<const Figures&>(machine.own);
}

template <class Figures>
Figures& own(Machine& machine) {
  return std::any_cast<Figures&>(machine.own);
}

/// A machine of that kind without any pixel: what a description, or a test, fills in.
Machine blank(const Kind& kind);

/// Makes the machine draw a picture of that size: an array that holds the whole of it becomes as large. Throws
/// InputError where its lines are longer than a chain of cells.
void set_picture_size(Machine& machine, Size size);

/// Works out what follows from the figures. Throws InputError where they do not fit each other.
void complete(Machine& machine);

/// Makes the machine draw the Program's picture with its memory. Throws as set_picture_size does.
void adopt(Machine& machine, const isa::Program& program);

/// The figures that may be ideal and are not, by key, in the order of the schema.
std::vector<std::string> idealisable(const Machine& machine);

/// Makes the figure ideal. Throws std::out_of_range for one that may not be.
void idealise(Machine& machine, std::string_view key);

/// The figures of the machine that are ideal.
std::vector<std::string> idealisations(const Machine& machine);

/// What a Program says of the machine that it is compiled for.
isa::MachineRecord record_of(const Machine& machine);

/// The figures, but the picture's, that are other in two machines of one kind: `alu.bits 4 instead of 1`, of the first
/// instead of the second.
std::vector<std::string> other_figures(const Machine& one, const Machine& other);

/// Whether the two are the same hardware: of one kind, with the same value of every figure but the picture's. Names and
/// sources do not matter.
bool same_hardware(const Machine& one, const Machine& other);

}  // namespace csgsim::machines
