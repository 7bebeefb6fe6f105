#include "hw/isa/manual.h"

#include <fmt/format.h>

#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>

#include "hw/isa/describe.h"
#include "hw/isa/operands.h"
#include "hw/isa/text.h"

namespace csgsim::isa {

namespace {

template <class... Args>
void put(std::string& page, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(page), format, std::forward<Args>(args)...);
}

constexpr std::string_view introduction = R"(# The instruction set

This page is generated from the tables in `hw/isa/`; the machines and the host use the same tables.

A **Program** is all that crosses from the host to a machine. It is a list of **segments**, each a rectangle of the
picture and the instructions broadcast to its pixels: the whole screen on Pixel-planes, a line on the scan-line array,
a square on the pixel-square renderer. A machine carries out the same instruction at every pixel of the segment at
once: what differs from pixel to pixel is whether a pixel takes part. The only jump is forward, over instructions for
which no pixel is left: `skip_if_none`.

## The state of a pixel

- **Memory**: the same number of bits at every pixel. A **field** is a run of consecutive bits, written
  `[base+:width]` with the least significant bit at `base`. Fields are unsigned numbers.
- **Enable**, E: one bit. An instruction writes memory only where E is 1, but for `enable_store`, which writes E
  itself and does so everywhere. Comparisons and edge tests only ever clear E, so a convex region is what is left of it
  after a test for each edge; `enable_all` begins anew.
- Memory and E are 0 at every pixel when a segment begins.

Pixel x counts from the segment's left and y from its top, both from 0.

## Linear expressions

The evaluator gives every pixel its own A\*x + B\*y + C, one bit a clock, least significant bit first, for integers A, B
and C. An instruction says two things about it:

- **width**: how many bits are streamed. They are a two's complement number. The host knows the range over the segment
  and asks for no more bits than that takes; if the sum needs more, its high bits are lost.
- **shift**: how many of the low bits are the fraction.

**F** is that number shifted right by `shift`, rounded towards minus infinity: it has width - shift bits and a sign.
Where F meets a field, it needs one bit more than the field. When F is written and does not fit the field (it is
negative or too large) its low bits are written and the pixel is disabled.

Example: `keep_max Z1, 12*x - 7*y + 991 (w35 >> 12)` streams 35 bits of 12x - 7y + 991 twice and drops 12 fraction bits.
Where E is 1 and the 23 bits of F that remain exceed Z1, it writes them to Z1. The host asks for 35 bits because
nothing in the segment needs more.

)";

constexpr std::string_view clocks_text = R"(## How clocks are counted

Each instruction expands to bit steps, and each bit step takes one clock. A machine's ALU works on one bit of a field
in a clock, or on several adjacent ones (`alu.bits`); linear expressions come one bit a clock in any case. Instructions
follow back to back: while the last bits of one expression run down the multiplier trees the first bits of the next
enter at the root. So the clocks of a Program are the sum of the table below over its instructions, plus the latency of
the trees once, at the end. The latency is one clock a level: ceil(log2 width) + ceil(log2 height) of the machine's
array. `global_or` and `skip_if_none` pay it too, as the controller waits for the answer; instructions that are skipped
take no clock. Both need a machine with a global OR.

| clocks | instructions |
|---|---|
)";

std::string_view clocks_of(ClockClass clock_class) {
  switch (clock_class) {
    case ClockClass::one: return "1";
    case ClockClass::linear_once: return "width of the linear expression";
    case ClockClass::linear_twice: return "twice the width of the linear expression: to compare, then to write";
    case ClockClass::field: return "width of the field, over the width of the ALU, rounded up";
    case ClockClass::two_fields:
      return "twice as many for the width of the fields; once on machines that read twice a clock";
    case ClockClass::answer: return "1 + latency of the trees";
  }
  return {};
}

std::string_view operand_name(OperandKind kind) {
  switch (kind) {
    case OperandKind::none: return {};
    case OperandKind::target: return "target";
    case OperandKind::source: return "source";
    case OperandKind::linear: return "linear";
    case OperandKind::constant: return "constant";
    case OperandKind::count: return "count";
  }
  return {};
}

std::string_view widths_of(const OpcodeInfo& row) {
  if (!is_field(row.operands[0])) return "";
  switch (field_widths(row.opcode)) {
    case FieldWidths::free: return "any";
    case FieldWidths::equal:
    case FieldWidths::elementwise: return "equal";
    case FieldWidths::one: return "1 bit";
  }
  return {};
}

std::string operands_of(const OpcodeInfo& row) {
  std::string out;
  for (const OperandKind kind : row.operands) {
    if (kind == OperandKind::none) continue;
    if (!out.empty()) out += ", ";
    out += operand_name(kind);
  }
  return out;
}

void put_opcodes(std::string& page) {
  put(page,
      "## Instructions\n\n"
      "E is the enable bit, t a target field, s and r source fields in the order of the operands, k a constant or a\n"
      "count, F the value of the linear expression.\n\n"
      "| number | instruction | operands | fields | meaning |\n|---|---|---|---|---|\n");
  for (const OpcodeInfo& row : opcode_table)
    put(page, "| {} | `{}` | {} | {} | {} |\n", static_cast<unsigned>(row.opcode), row.name, operands_of(row),
        widths_of(row), row.meaning);
  put(page,
      "\nThe fields of one instruction do not overlap, except that those of the `bit_` instructions may be the "
      "same.\n\n");
}

void put_clocks(std::string& page) {
  page += clocks_text;
  for (const ClockClass clock_class : {ClockClass::one, ClockClass::linear_once, ClockClass::linear_twice,
                                       ClockClass::field, ClockClass::two_fields, ClockClass::answer}) {
    std::string names;
    for (const OpcodeInfo& row : opcode_table)
      if (row.clock_class == clock_class) put(names, "{}`{}`", names.empty() ? "" : " ", row.name);
    put(page, "| {} | {} |\n", clocks_of(clock_class), names);
  }
}

void put_origins(std::string& page) {
  put(page,
      "\n## Origins\n\n"
      "Each instruction says whom it serves: a purpose, the primitive whose surface is drawn, and while classifying "
      "the\nprimitive it is compared with. Machines ignore it; statistics and waves show it.\n\n"
      "| purpose | meaning |\n|---|---|\n");
  for (const PurposeInfo& row : purpose_table) put(page, "| `{}` | {} |\n", row.name, row.meaning);
}

void put_roles(std::string& page) {
  put(page, "\n## Roles of fields\n\nA Program names the fields that pictures, statistics and waves read. Roles:");
  for (const std::string_view name : field_role_names) put(page, " `{}`", name);
  put(page, ".\n");
}

void put_limits(std::string& page) {
  put(page,
      "\n## Limits\n\n| what | most |\n|---|---|\n"
      "| width of a field | {} bits |\n"
      "| width of a linear expression | {} bits |\n"
      "| \\|A\\| \\* segment width + \\|B\\| \\* segment height + \\|C\\| | below 2^62 |\n"
      "| memory of a pixel | {} bits |\n"
      "| side of the array | {} pixels |\n\n"
      "A Program that breaks a rule of this page is refused when it is built and again when it is loaded, with the "
      "segment\nand instruction, or the line and column.\n",
      max_field_width, max_linear_width, max_memory_bits, max_array_side);
}

constexpr std::string_view sample = R"(.array width=512 height=512 memory_bits=72
.depth perspective=false near=10.5 far=80
.model file="gear.csg" primitives=2 unions=1 halfspaces=12
.compile strategy="auto" colouring="field" z_bits=20 fraction_bits=12 edge_on_fraction=0.5 stack_bits=1 tree_depth=1 rendered=2 classified=1
.field Z1 [0+:20] candidate_depth
.field in [40] stack
.primitive "wheel"
.primitive "tooth"
.segment width=512 height=512 primitives=2 halfspaces=12
enable_all
set_constant Z1, 0 ; render p0
edge_not_negative 40*x - 3*y - 812 (w16) ; render p0
keep_max Z1, 12*x - 7*y + 991 (w35 >> 12) ; render p0
skip_if_none 2 ; classify p0
linear_le Z1, 3*x + 77 (w33 >> 12) ; classify p0 against p1
enable_store in ; classify p0 against p1
set_constant [41+:8], 0xff ; shade p0
)";

template <class Record>
void put_keys(std::string& page, std::string_view name, const Record& record) {
  put(page, "- `.{}`:", name);
  describe(record, [&](std::string_view key, const auto&) { put(page, " `{}`", key); });
  put(page, "\n");
}

void put_text_form(std::string& page) {
  put(page,
      "\n## The text form\n\n"
      "`csgsim disasm` prints a Program as text, and a text file is run like a binary one. One directive or "
      "instruction "
      "stands\non a line; `#` begins a comment.\n\n```\n");
  std::ostringstream printed;
  print(printed, parse(sample, "sample"));
  page += printed.view();
  put(page,
      "```\n\n"
      "- A field is a name that `.field` gave it, `[bit]`, or `[base+:width]`.\n"
      "- A linear expression is a sum of A\\*x, B\\*y and C, each at most once, then `(wWIDTH)` or `(wWIDTH >> "
      "SHIFT)`.\n"
      "- A constant or a count is decimal, or hexadecimal after `0x`.\n"
      "- After `;` stands the origin: the purpose, `pN` for a primitive, `against pN` for the one it is compared "
      "with.\n"
      "  Primitives count from 0 in the order of the `.primitive` lines. Without `;` the purpose is `{}`.\n"
      "- In strings `\\\"` and `\\\\` stand for `\"` and `\\`, and `\\xNN` for the byte with that hexadecimal code.\n\n"
      "`.array` comes first. `.field NAME PLACE ROLE` and `.primitive \"NAME\"` stand once for each, and before the "
      "first\n`.segment`. The other directives take `key=value` pairs; what is left out is zero (`far`: 1):\n\n",
      info(Origin{}.purpose).name);
  const Program program;
  describe_header(program, [&](std::string_view name, const auto& record) { put_keys(page, name, record); });
  put_keys(page, "segment", Segment{});
}

}  // namespace

std::string instruction_set_page() {
  std::string page(introduction);
  put_opcodes(page);
  put_clocks(page);
  put_origins(page);
  put_roles(page);
  put_limits(page);
  put_text_form(page);
  return page;
}

}  // namespace csgsim::isa
