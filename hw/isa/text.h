// Prints and parses the text form of Programs.
// Used by hw/wave and sim.
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

#include "hw/isa/field_role.h"
#include "hw/isa/program.h"

namespace csgsim::isa {

/// The text form of a Program, with one directive or instruction per line:
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
/// - `#` begins a comment, which ends with its line. Words are separated by any number of blanks. print writes the
///   numbers of segments and instructions (hw/isa/instruction_numbers.h) as comments.
/// - Directives begin with a dot and come first, `.array` before all others; then come the segments. `key=value` pairs
///   may be in any order; missing values are zero (near 0, far 1). Values are numbers, `true` or `false`, strings, and
///   lists of strings.
/// - `.frame` names the displayed field, before any `.field` with the role colour, which must be the same field.
///   `.extent first=3 last=40` lines give the rows of one piece each, for a host that keeps an active list.
/// - `.display_model` lines hold hexadecimal digits, two per byte, for machines that divide the model themselves.
///   Segments then have keys for the work of their group, followed by `.step` lines for the work of each step.
/// - A field is the name of a `.field`, `[bit]`, or `[base+:width]`: `width` bits of pixel memory with the least
///   significant bit at `base`.
/// - A linear expression is a sum of A*x, B*y and C, each at most once, then `(wWIDTH)` or `(wWIDTH >> SHIFT)`.
/// - Squares are a sum of A*x*x, B*x*y and C*y*y, each at most once, then `(wWIDTH)`.
/// - A constant or a count is decimal, or hexadecimal after `0x`.
/// - The origin follows `;`: a purpose, `pN` for the primitive with index N, counted from 0 in the order of the
///   `.primitive` lines, and `against pN` for the primitive it is compared with. Without `;` the purpose is `setup`.
/// - Words are letters, digits, `_` and `.`, not beginning with a digit or dot. Field names that are not words are
///   written as strings. In strings `\"` and `\\` stand for `"` and `\`, and `\xNN` for the byte with that hexadecimal
///   code.
///
/// parse() restores the printed Program exactly, including every bit of its doubles.
void print(std::ostream& out, const Program& program);

/// An instruction in text form without its origin; `fields` supplies the names.
std::string text_of(const Instruction& instruction, std::span<const NamedField> fields);

/// A linear expression in text form.
std::string text_of(const Linear& linear);

/// A field's place in text form.
std::string text_of(Field field);

/// An origin in text form, as after a `;`.
std::string text_of(const Origin& origin, const Facts& facts);

/// Reads the text form; `name` is the file's name in errors. The result is valid. Throws InputError of the form
/// `name:line:column: what is wrong; what to do`; for an unknown word it suggests the nearest known one.
Program parse(std::string_view text, std::string_view name);

}  // namespace csgsim::isa
