// A machine with its parameters.
// Used by hw, host/emit, host/setup and sim.
#pragma once

#include <any>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hw/isa/link_word.h"
#include "hw/isa/program.h"
#include "hw/machines/host.h"

namespace csgsim::machines {

class Kind;

/// The values that a number may plausibly have, including both limits.
struct FigureRange {
  std::int64_t low = 0;
  std::int64_t high = 0;
  std::string reason;
};

/// One parameter of a machine description, with its provenance.
struct Figure {
  std::string key;                     ///< key in the file, for instance `array.width`
  std::string value;                   ///< value as text; `ideal` if the hardware sets no limit
  std::string unit;                    ///< may be empty
  std::string provenance;              ///< `published` or `assumed`
  std::string source;                  ///< the publication, or the reason for the assumption
  std::optional<FigureRange> range{};  ///< unset if the file states no range, and for changed values
};

/// Width and height of a picture, pixels.
struct Size {
  std::uint32_t width = 0;
  std::uint32_t height = 0;

  constexpr bool operator==(const Size&) const = default;
};

/// The path of instructions to a machine: words on a link that end in a FIFO (format: hw/isa/wire.h).
struct Link {
  std::uint32_t width = isa::LinkWord::max_bits;  ///< bits of a word
  std::uint32_t word_clocks = 1;                  ///< clocks from one word to the next
  std::uint32_t fifo_depth = 16;                  ///< words
  std::uint32_t latency = 0;  ///< clocks from a request, at the beginning of a frame or a jump, to the first word

  constexpr bool operator==(const Link&) const = default;
};

/// A logic-enhanced frame buffer, as described in hw/machines/NAME.toml.
struct Machine {
  std::string name;
  std::string description;
  const Kind* kind = nullptr;          ///< the architecture (hw/machines/kind.h)
  isa::ArrayShape array;               ///< pixel processors (of one chain or renderer) and memory bits of each
  Size picture;                        ///< size of the picture that the machine draws
  std::uint64_t clock_hz = 0;          ///< clock frequency: bit steps or packets per second
  std::uint32_t memory_reads = 1;      ///< read ports of pixel memory, 1 or 2
  std::uint32_t evaluator_degree = 1;  ///< degree of the linear or quadratic expressions at the pixels, 1 or 2
  std::uint32_t register_levels = 1;   ///< tree levels from one register to the next
  std::uint32_t evaluator_bits = 1;    ///< bits of an expression that reach the pixels per clock: at most alu_bits
  std::uint32_t alu_bits = 1;          ///< adjacent field bits that the ALU processes, and a port delivers, per clock
  std::uint32_t clear_clocks = 0;      ///< clocks to clear all memory of the pixel processors
  Link link;
  Host host;
  std::any own;                 ///< parameters that only machines of this kind have; see kind_figures<Figures>()
  std::vector<Figure> figures;  ///< every parameter of the file, in the order of the file
};

/// The parameters that only the machine's kind has, in the type that the kind defines. Throws std::bad_any_cast for a
/// machine of another kind.
template <class Figures>
const Figures& kind_figures(const Machine& machine) {
  return std::any_cast<const Figures&>(machine.own);
}

template <class Figures>
Figures& kind_figures(Machine& machine) {
  return std::any_cast<Figures&>(machine.own);
}

/// A machine of the given kind without pixels, to be filled in by a description or a test.
Machine blank_machine(const Kind& kind);

/// Sets the size of the picture. An array that holds the whole picture gets the same size. Throws InputError if lines
/// of the picture are longer than a chain of cells.
void set_picture_size(Machine& machine, Size size);

/// Computes values that follow from the parameters. Throws InputError if the parameters are inconsistent.
void complete(Machine& machine);

/// Sets the machine's picture size and memory to the Program's. Throws like set_picture_size().
void adopt_shape(Machine& machine, const isa::Program& program);

/// The value of a parameter that the machine uses, as text. It differs from Figure::value if the description leaves the
/// value to a processor, or if options have changed the picture's size or the memory.
std::string used_value(const Figure& figure, const Machine& machine);

/// Keys of the parameters that could be ideal but are not, in the order of the schema.
std::vector<std::string> ideal_candidates(const Machine& machine);

/// Makes the parameter ideal. Throws std::out_of_range if the schema does not allow this.
void make_ideal(Machine& machine, std::string_view key);

/// Keys of the machine's ideal parameters.
std::vector<std::string> ideal_parameters(const Machine& machine);

/// The record of the machine for Programs that are compiled for it.
isa::MachineRecord machine_record(const Machine& machine);

/// The parameters that differ between two machines of one kind, except the picture size, as texts such as `alu.bits 4
/// instead of 1`, where 4 is the value of `first`.
std::vector<std::string> figure_differences(const Machine& first, const Machine& second);

/// Whether two machines are the same hardware: of one kind, with equal parameters except the picture size. Names and
/// sources are ignored.
bool is_same_hardware(const Machine& first, const Machine& second);

}  // namespace csgsim::machines
