// Commands of the debugger, and their parser.
// Used by sim/debug.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::debug {

/// A field of one pixel of the picture, or its enable bit.
struct WatchedField {
  isa::Field field;  ///< width 0 stands for E
  std::uint32_t x = 0;
  std::uint32_t y = 0;

  bool operator==(const WatchedField&) const = default;
};

enum class Relation : std::uint8_t { less, not_greater, equal, not_equal, not_less, greater, changes };

/// Condition on a watched field.
struct Condition {
  WatchedField watched;
  Relation relation{};
  std::uint32_t value = 0;  ///< value to compare with; unused for `changes`

  bool operator==(const Condition&) const = default;
};

/// Stops before the instruction with that number in the whole Program.
struct AtInstruction {
  std::uint64_t number = 0;
  bool operator==(const AtInstruction&) const = default;
};

/// Stops before the first instruction that is not completely issued when the clock begins.
struct AtClock {
  std::uint64_t clock = 0;
  bool operator==(const AtClock&) const = default;
};

/// Stops before the first of consecutive instructions that serve the primitive.
struct AtPrimitive {
  std::uint32_t primitive = 0;
  bool operator==(const AtPrimitive&) const = default;
};

/// A place or condition at which a run stops.
using Target = std::variant<AtInstruction, AtClock, AtPrimitive, Condition>;

struct Nothing {};  ///< an empty line, or a comment
struct RunOn {};
struct StepOn {
  std::uint64_t count = 1;
};
struct Until {
  Target target;
};
struct Back {
  std::uint64_t count = 1;
};
struct SetBreak {
  Target target;
};
struct DeleteBreak {
  std::uint64_t number = 0;
};
struct ListBreaks {};
struct PrintValue {
  WatchedField watched;
};
struct PrintPixel {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
};
struct PrintEnable {};
struct Where {};
struct ListAround {
  std::optional<std::uint64_t> number;  ///< number of an instruction; the next one if absent
};
struct TakePicture {
  isa::Field field;  ///< width 0 stands for E
  std::string file;
};
struct WriteCheckpoint {
  std::string file;
};
struct ReadCheckpoint {
  std::string file;
};
struct Help {};
struct Quit {};

using Command =
    std::variant<Nothing, RunOn, StepOn, Until, Back, SetBreak, DeleteBreak, ListBreaks, PrintValue, PrintPixel,
                 PrintEnable, Where, ListAround, TakePicture, WriteCheckpoint, ReadCheckpoint, Help, Quit>;

/// A command and its meaning, for help and for completion.
struct CommandInfo {
  std::string_view word;
  std::string_view form;
  std::string_view meaning;
};

/// The commands. The grammar also reads abbreviations and the words of gdb for them: r and c (run), s, n, next, stepi
/// and nexti (step), u, b, d, p, l, q and exit, h, bt and w (where), rs and reverse-step (back).
inline constexpr CommandInfo command_table[] = {
    {"run", "run", "continue to the next breakpoint or to the end"},
    {"step", "step [N]", "execute the next instruction, or the next N"},
    {"until", "until STOP", "continue to STOP, a breakpoint or the end"},
    {"back", "back [N]", "go back before the last instruction, or the last N"},
    {"break", "break STOP", "set a breakpoint"},
    {"breakpoints", "breakpoints", "list the breakpoints"},
    {"delete", "delete N", "delete breakpoint N"},
    {"print", "print FIELD[x,y]", "print a field of a pixel; E is its enable bit"},
    {"print", "print x,y", "print all fields of a pixel"},
    {"print", "print E", "print the number of enabled pixels"},
    {"where", "where", "show the next instruction, its purpose and its clocks"},
    {"list", "list [iN]", "list the instructions around the next one, or around iN"},
    {"picture", "picture FIELD FILE.png", "write a field, or E, of every pixel as a picture"},
    {"checkpoint", "checkpoint FILE", "write the state of the run, for resume and csgsim run --resume"},
    {"resume", "resume FILE", "continue from a checkpoint"},
    {"help", "help", "show this list"},
    {"quit", "quit", "end the session"},
};

/// The forms of STOP, in the format of command_table.
inline constexpr CommandInfo stop_table[] = {
    {"i", "i123", "before instruction 123 of the whole Program"},
    {"clock", "clock N", "before the first instruction not completely issued when clock N begins"},
    {"primitive", "primitive P", "before instructions of a primitive: its index, as 3 or p3, or its name"},
    {"", "Z2[100,20] < 5000", "after the instruction that makes it true; also <= > >= == !="},
    {"", "E[100,20]", "after the instruction that enables the pixel; for a field: makes it nonzero"},
    {"not", "not E[100,20]", "after the instruction that disables the pixel; for a field: makes it 0"},
    {"change", "change Z2[100,20]", "after the instruction that changes it"},
};

/// Parses one line. A field is given by its name, in double quotes if it is not a word, or by its place, [base+:width];
/// `#` begins a comment. Throws InputError in the form `name:line:column: what is wrong; what to do`.
Command parse_command(std::string_view text, std::string_view name, std::size_t line, const isa::Program& program);

}  // namespace csgsim::debug
