#include "hw/isa/manual.h"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>

#include "hw/isa/describe.h"
#include "hw/isa/field_role.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/isa/text.h"
#include "hw/isa/wire.h"

namespace csgsim::isa {

namespace {

template <class... Args>
void put(std::string& page, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(page), format, std::forward<Args>(args)...);
}

constexpr std::string_view introduction = R"(# The instruction set

This page is generated from the tables in `hw/isa/` that the machines and the host use.

A **Program** holds everything that a host sends to a machine. It is a list of **segments**, each a rectangle of
the picture and the instructions broadcast to its pixels: the whole screen on Pixel-planes, a line on the scan-line
array, a square on the pixel-square renderer. Every pixel of the segment receives the same instructions; its enable bit
decides whether it takes part. The only jump goes forward, over instructions for which no pixel is enabled:
`skip_if_none`.

## The state of a pixel

- **Memory**: the same number of bits at every pixel. A **field** is a run of consecutive bits, an unsigned number,
  written `[base+:width]` with the least significant bit at `base`.
- **Enable**, E: one bit. An instruction writes memory only where E is 1, except `enable_store`, which writes E
  everywhere. Comparisons and edge tests only clear E, so a test for each edge leaves a convex region; `enable_all`
  enables every pixel again.
- Memory and E are 0 at every pixel when a segment begins.

Pixel x counts from the segment's left and y from its top, both from 0.

## Linear expressions

The evaluator gives every pixel its own A\*x + B\*y + C, least significant bit first, for integers A, B and C;
Pixel-planes streams one bit per clock. An instruction adds two numbers:

- **width**: the number of bits streamed, as a two's complement number. The host chooses no more bits than the range
  over the segment needs; if the sum needs more, its high bits are lost, and a run counts an overflow. Only `stripe`
  drops them by design: its pattern repeats every 2^width of the sum.
- **shift**: the number of low bits that are the fraction.

**F** is that number shifted right by `shift`, rounded towards minus infinity: it has width - shift bits and a sign.
Where F is compared or combined with a field, it needs one bit more than the field. Where F is written and does not fit
the field, negative or too large, its low bits are written and the pixel is disabled.

Example: `keep_max Z1, 12*x - 7*y + 991 (w35 >> 12)` streams 35 bits of 12x - 7y + 991 twice and drops 12 fraction bits.
Where E is 1 and the 23 bits of F that remain exceed Z1, it writes them to Z1.

## Quadratic expressions

`squares` carries three more coefficients, those of x\*x, x\*y and y\*y. They are streamed together with those of the
next instruction, which must have a linear expression of the same width. Its sum is then A\*x\*x + B\*x\*y + C\*y\*y
from the squares plus its own A\*x + B\*y + C; width, shift and overflow keep their meaning. No skip may end between
the two. Not every machine's evaluator supports squares.

Example: `squares 3*x*x - 2*x*y + 5*y*y (w35)`, then `edge_not_negative 40*x - 3*y - 812 (w35)` disables the pixels
where 3xx - 2xy + 5yy + 40x - 3y - 812 is negative.

## Roots

`root` takes the square root of a field in place. In a field of 2w + 1 bits, all bits except the top bit are D, an
unsigned number. The upper w bits become q, the root of D rounded down. The lower w + 1 become the low bits of the
remainder: D - q\*q if q is odd, D - (q + 1)\*(q + 1) if it is even. The steps are those of non-restoring
division: each appends two more bits of D to the remainder R and subtracts 4q + 1 from it, or adds 4q + 3 if R was
negative; the next bit of q is 1 if R is then not negative. q grows downwards from the top bit of the field, in bits
that R no longer needs.

)";

constexpr std::string_view clocks_text = R"(## How clocks are counted

Each bit step takes one clock. In each clock a machine's ALU processes one bit of a field or several adjacent bits
(`alu.bits`), and its trees deliver one bit of a linear expression or several (`evaluator.bits`). Instructions
follow back to back: while the last bits of one expression run down the multiplier trees, the first bits of the next
enter at the root. So a frame takes at least the sum of the table below over its instructions, plus the latency of the
trees once, at the end; each machine's page lists its other waits. The latency is one clock per level: ceil(log2 width)
+ ceil(log2 height) of the machine's array, or less if only every r-th level has registers
(`evaluator.register_levels`). `global_or` and `skip_if_none` wait for the answer: the latency plus one clock for each
level of the global OR. Skipped instructions take no clock; the jump over them takes a request on the link. Both
instructions need a machine with a global OR.

| clocks | instructions |
|---|---|
)";

std::string_view clocks_of(ClockClass clock_class) {
  switch (clock_class) {
    case ClockClass::one: return "1";
    case ClockClass::linear_once: return "width of the linear expression, over that of the trees, rounded up";
    case ClockClass::linear_twice: return "twice as many: to compare, then to write";
    case ClockClass::field: return "width of the field, over the width of the ALU, rounded up";
    case ClockClass::two_fields:
      return "twice as many for the width of the wider field; once on machines that read twice per clock";
    case ClockClass::root:
      return "w\\*w + 2w for a root of w bits; (w\\*w + 5w) / 2 on machines that read twice per clock";
    case ClockClass::answer: return "1 + latency of the trees + levels of the global OR";
  }
  return {};
}

std::string_view operand_name(OperandKind kind) {
  constexpr auto names =
      std::to_array<std::string_view>({"", "target", "source", "linear", "constant", "count", "squares"});
  return names.at(static_cast<std::size_t>(kind));
}

std::string_view widths_of(const OpcodeInfo& row) {
  if (!is_field(row.operands[0])) return "";
  switch (row.widths) {
    case FieldWidths::free: return "any";
    case FieldWidths::equal:
    case FieldWidths::elementwise: return "equal";
    case FieldWidths::one: return "1 bit";
    case FieldWidths::narrower: return "s no wider than t";
    case FieldWidths::wide: return "any, also wide";
    case FieldWidths::odd: return "odd, also wide";
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

/// Bits of an instruction on a link, as a formula in the width w of its linear expression and n of its target.
std::string wire_bits_formula(Opcode opcode) {
  const unsigned fixed = wire_bits(Instruction{opcode, {}, {}, 0, {}});
  const unsigned a_linear_bit = wire_bits(Instruction{opcode, {}, {0, 0, 0, 1, 0}, 0, {}}) - fixed;
  const unsigned a_target_bit = wire_bits(Instruction{opcode, {{{0, 1}}}, {}, 0, {}}) - fixed;
  std::string sum = fmt::format("{}", fixed);
  if (a_linear_bit > 0) put(sum, " + {}w", a_linear_bit);
  if (a_target_bit > 0) put(sum, " + n");
  return sum;
}

void put_opcodes(std::string& page) {
  put(page,
      "## Instructions\n\n"
      "E is the enable bit, t a target field, s and r source fields in the order of the operands, k a constant or a\n"
      "count, F the value of the linear expression, w the width of that or of squares, n that of the target.\n\n"
      "| number | instruction | operands | fields | bits on a link | meaning |\n|---|---|---|---|---|---|\n");
  for (const OpcodeInfo& row : opcode_table)
    put(page, "| {} | `{}` | {} | {} | {} | {} |\n", static_cast<unsigned>(row.opcode), row.name, operands_of(row),
        widths_of(row), wire_bits_formula(row.opcode), row.meaning);
  put(page,
      "\nThe fields of one instruction do not overlap, except that those of the `bit_` instructions may be the "
      "same.\n\n");
}

void put_link(std::string& page) {
  put(page,
      "## On a link\n\n"
      "Over a link of 1 to {} bits the stream travels as **commands**: the instructions, and three more. A command is "
      "its\nnumber in {} bits, then its operands in order, each with its least significant bit first. It "
      "begins at\na new word of the link and takes ceil(bits / width of the link) words, padded with 0.\n\n"
      "| operand | bits on a link |\n|---|---|\n"
      "| target, source | base {}, width {} |\n"
      "| linear | width {}, shift {}, then A, B and C in `width` bits each |\n"
      "| squares | width {}, then A, B and C in `width` bits each |\n"
      "| constant | as many as its target has |\n"
      "| count | {} |\n\n",
      LinkWord::max_bits, opcode_bits, wire_base_bits, wire_field_width_bits, wire_linear_width_bits, wire_shift_bits,
      wire_linear_width_bits, wire_count_bits);
  put(page,
      "A, B and C travel as two's complement numbers modulo 2^width, because higher bits do not affect F. Origins "
      "are not sent.\n\n"
      "| number | command | bits on a link | meaning |\n|---|---|---|---|\n"
      "| {} | segment | {} | x, y, width and height of a segment, {} bits each: memory and E become 0 there; "
      "the following instructions are for its pixels |\n"
      "| {} | end of segment | {} | the pixels of the segment are finished |\n"
      "| {} | end of frame | {} | base and width of the colour field, {} and {} bits: this field is displayed, "
      "or nothing if the width is 0 |\n\n",
      SegmentStart::number, wire_bits(SegmentStart{}), wire_region_bits, SegmentEnd::number, wire_bits(SegmentEnd{}),
      FrameEnd::number, wire_bits(FrameEnd{}), wire_base_bits, wire_field_width_bits);
  put(page,
      "Example: `set_constant [16+:8], 0xa5` is 18 in {} bits, 16 in {}, 8 in {} and 0xa5 in 8, a total of {} bits: "
      "one "
      "word\nof a link of 32 bits, four of a link of 10.\n\n",
      opcode_bits, wire_base_bits, wire_field_width_bits,
      wire_bits(Instruction{Opcode::set_constant, {{{16, 8}}}, {}, 0xa5, {}}));
}

void put_clocks(std::string& page) {
  page += clocks_text;
  for (const ClockClass clock_class :
       {ClockClass::one, ClockClass::linear_once, ClockClass::linear_twice, ClockClass::field, ClockClass::two_fields,
        ClockClass::root, ClockClass::answer}) {
    std::string names;
    for (const OpcodeInfo& row : opcode_table)
      if (row.clock_class == clock_class) put(names, "{}`{}`", names.empty() ? "" : " ", row.name);
    put(page, "| {} | {} |\n", clocks_of(clock_class), names);
  }
}

void put_origins(std::string& page) {
  put(page,
      "\n## Origins\n\n"
      "Each instruction records its origin: a purpose, the primitive whose surface is drawn, the primitive it is\n"
      "compared with while classifying, and the effect it belongs to.\n\n"
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
      "| width of a field of `load_linear`, `linear_plus`, `linear_minus`, `root` | {} bits |\n"
      "| width of a linear expression | {} bits |\n"
      "| instructions skipped by one instruction | {} |\n"
      "| \\|A\\| \\* segment width + \\|B\\| \\* segment height + \\|C\\| | below 2^62 |\n"
      "| the same with \\|A\\| \\* width^2 + \\|B\\| \\* width \\* height + \\|C\\| \\* height^2 of squares | below "
      "2^62 |\n"
      "| memory of a pixel | {} bits |\n"
      "| side of the array | {} pixels |\n\n"
      "A Program that breaks a rule of this page is rejected; the error names the segment and instruction, or the line "
      "and column.\n",
      max_field_width, max_wide_field_width, max_linear_width, max_count, max_memory_bits, max_array_side);
}

constexpr std::string_view sample = R"(.array width=512 height=512 memory_bits=72
.depth perspective=false near=10.5 far=80
.model file="gear.csg" primitives=2 unions=1 halfspaces=12
.machine name="pixel-planes-4+alu.bits=4"
.frame colour_base=41 colour_bits=8
.compile strategy="auto" colouring="field" z_bits=20 fraction_bits=12 edge_on_fraction=0.5 stack_bits=1 tree_depth=1 rendered=2 classified=1
.field Z1 [0+:20] candidate_depth
.field in [40] stack
.field colour [41+:8] colour
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
set_constant colour, 0xff ; shade p0
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
      "`csgsim disasm` prints a Program as text, and a text file is run like a binary one. `#` begins a comment. "
      "Printed\ncomments number the segments (`s0`) and, through all segments, the instructions (`i0`); other commands "
      "use these numbers.\n\n```\n");
  std::ostringstream printed;
  print(printed, parse(sample, "sample"));
  page += printed.view();
  put(page,
      "```\n\n"
      "- A field is a name that `.field` gave it, `[bit]`, or `[base+:width]`.\n"
      "- A linear expression is a sum of A\\*x, B\\*y and C, each at most once, then `(wWIDTH)` or `(wWIDTH >> "
      "SHIFT)`.\n"
      "- Squares are a sum of A\\*x\\*x, B\\*x\\*y and C\\*y\\*y, each at most once, then `(wWIDTH)`.\n"
      "- A constant or a count is decimal, or hexadecimal after `0x`.\n"
      "- The origin follows `;`: the purpose, `pN` for a primitive, `against pN` for the one it is compared "
      "with,\n  `for eN` for the effect it belongs to, counted from 0 in the order of `.compile`'s `effects`.\n"
      "  Primitives count from 0 in the order of the `.primitive` lines. If one is drawn in several convex pieces,\n"
      "  as in `pieces=3` on its line, `pN.K` is one of them, from 0. Without `;` the purpose is `{}`.\n"
      "- In strings `\\\"` and `\\\\` stand for `\"` and `\\`, and `\\xNN` for the byte with that hexadecimal code.\n\n"
      "`.array` comes first. `.field NAME PLACE ROLE`, `.primitive \"NAME\"` and `.extent` appear once per item, "
      "before the first\n`.segment`. The other directives contain `key=value` pairs; missing values are zero (`far`: "
      "1).\n\n"
      "A machine acts only on `.array`, `.frame`, `.extent`, `.display_model`, `.prepare`, `.prepare_model`, the "
      "region and\ndivision counts of a segment, and the instructions. Everything else, including origins, is for "
      "users: "
      "without it clocks,\ninstruction counts and picture are the same.\n\n"
      "- `.machine` names the machine that the Program was compiled for, with its changed parameters, and lists its "
      "parameters,\n  `\"KEY=VALUE\"` each; the others have csgsim's values. Commands run the Program on it and reject "
      "another "
      "kind of machine\n  or one with less memory.\n"
      "- `.frame` gives the field whose colour is displayed; none if `colour_bits` is 0. Bases have 12 bits, widths "
      "6.\n"
      "- `.extent` lines are for a host that keeps an active list per line: the first and the last row with "
      "instructions\n  for each primitive's piece, 16 bits each.\n"
      "- The numbers of a segment's region have 16 bits each, its division counts 64.\n\n"
      "The keys:\n\n",
      info(Origin{}.purpose).name);
  const Program program;
  describe_header(program, [&](std::string_view name, const auto& record) { put_keys(page, name, record); });
  put_keys(page, "extent", RowExtent{});
  put_keys(page, "segment", Segment{});
  put(page,
      "\nFor a machine that divides the model itself, `.display_model \"DIGITS\"` lines before the first `.segment` "
      "hold "
      "the data\nsent to it, two hexadecimal digits per byte. Segments then have more keys, for the work of dividing "
      "their group,\n\n");
  put_keys(page, "segment", DivisionCounts{});
  put(page, "\nand are followed by `.step` lines for the work of each surface:\n\n");
  put_keys(page, "step", DivisionStep{});
  put(page,
      "\n`.prepare` lines count the work of the host before it writes instructions: one line before the first "
      "`.segment` for "
      "the\nframe, and one after the line of each segment with such work ([the host](host.md)):\n\n");
  put_keys(page, "prepare", Preparation{});
  put(page,
      "\nA `.prepare_model` line before the first `.segment` has the same keys for work that is done once per model, "
      "whatever\nthe camera. `.pruning` lines say what the prunings did: for how many items each was `tried`, how many "
      "it `decided`,\nhow many were `left` because a test was not worth its time, the estimated instructions `saved`, "
      "and the host's\n`nanoseconds`:\n\n");
  put_keys(page, "pruning", PruningFacts{});
}

}  // namespace

std::string instruction_set_page() {
  std::string page(introduction);
  put_opcodes(page);
  put_link(page);
  put_clocks(page);
  put_origins(page);
  put_roles(page);
  put_limits(page);
  put_text_form(page);
  return page;
}

}  // namespace csgsim::isa
