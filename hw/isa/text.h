#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

#include "hw/isa/field_role.h"
#include "hw/isa/program.h"

namespace csgsim::isa {

/// The text form of a Program: one directive or instruction a line.
///
///     # csgsim program
///     .array width=512 height=512 memory_bits=72
///     .machine name="pixel-planes-4" kind="frame-buffer" figures=["array.width=512", ...]
///     .frame colour_base=41 colour_bits=24 background=16777189
///     .depth perspective=false near=10.5 far=80
///     .model file="gear.csg" primitives=2 unions=1 differences=0 intersections=0 halfspaces=12
///     .compile strategy="auto" z_bits=20 fraction_bits=12 ... effects=["shadow"]
///     .field Z1 [0+:20] candidate_depth
///     .field in [40] stack
///     .primitive "tooth"
///     .segment x=0 y=0 width=512 height=512 primitives=2 halfspaces=12  # s0
///       enable_all                                   ; setup                   # i0
///       set_constant Z1, 1048575                     ; setup                   # i1
///       keep_max Z1, 12*x - 7*y + 991 (w35 >> 12)    ; render p0               # i2
///       linear_ge Z1, 3*x (w30)                      ; classify p0 against p1  # i3
///       enable_store in                              ; classify p0 against p1  # i4
///       set_constant [41+:8], 0xff                   ; shade p0                # i5
///
/// - `#` begins a comment, which ends with its line. Blanks separate; how many does not matter. print writes the
///   numbers of segments and of instructions (hw/isa/instruction_numbers.h) as comments.
/// - Directives that begin with a dot come first, `.array` before all others, and then the segments. `key=value` pairs
///   come in any order; what is left out is zero (near 0, far 1). Values are numbers, `true` or `false`, strings, and
///   lists of strings.
/// - `.frame` says which field is shown, before a `.field` of role colour, which has to be that. `.extent first=3
///   last=40` lines say the rows of a piece each, for a host that keeps an active list.
/// - `.display_model` lines hold hexadecimal digits, two a byte, for machines that divide the model themselves.
///   Segments then have keys for what a group of them takes, and `.step` lines after them for what each takes.
/// - A field is the name of a `.field`, `[bit]`, or `[base+:width]`: width bits of pixel memory, the least significant
///   at base.
/// - A linear expression is a sum of A*x, B*y and C, each once at most, then `(wWIDTH)` or `(wWIDTH >> SHIFT)`.
/// - Squares are a sum of A*x*x, B*x*y and C*y*y, each once at most, then `(wWIDTH)`.
/// - A constant or a count is decimal, or hexadecimal after `0x`.
/// - After `;` stands the origin: a purpose, `pN` for the primitive with index N, counted from 0 in the order of the
///   `.primitive` lines, and `against pN` for the one it is compared with. Without `;` it is `setup`.
/// - Words are letters, digits, `_` and `.`, not beginning with a digit or dot. Names of fields that are no words are
///   strings. In strings `\"` and `\\` stand for `"` and `\`, and `\xNN` for the byte with that hexadecimal code.
///
/// print writes it so that parse reads the same Program back, doubles bit by bit.
void print(std::ostream& out, const Program& program);

/// An instruction as the text form has it, without its origin; `fields` give names.
std::string text_of(const Instruction& instruction, std::span<const NamedField> fields);

/// A linear expression as the text form has it.
std::string text_of(const Linear& linear);

/// A field's place as the text form has it.
std::string text_of(Field field);

/// Whom an instruction serves, as the text form has it behind a `;`.
std::string text_of(const Origin& origin, const Facts& facts);

/// Reads the text form; `name` is the file's in errors. The result is valid. Throws InputError, `name:line:column:
/// what, and what to do`; unknown words name the nearest known one.
Program parse(std::string_view text, std::string_view name);

}  // namespace csgsim::isa
