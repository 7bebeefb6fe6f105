#pragma once

#include <string>

#include "hw/base/error.h"
#include "hw/isa/facts.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/program.h"

namespace csgsim::test {

/// One instruction of each kind of operand, on an array of 8 x 4 pixels with 40 bits.
inline isa::Program sample_program() {
  using isa::Opcode;
  using isa::Purpose;
  isa::Program program;
  program.shape = {8, 4, 40};
  program.machine = {"pixel-planes-4+alu.bits=4", "frame-buffer", {"alu.bits=4", "scan_out.port=shared"}};
  program.colour = {17, 12};
  program.background = 0x00a0b0;
  program.extents = {{0, 3}, {2, 2}};
  program.facts->fields = {{"Z1", {0, 8}, isa::FieldRole::candidate_depth},
                           {"in", {16, 1}, isa::FieldRole::stack},
                           {"two words", {8, 8}, isa::FieldRole::depth}};
  program.facts->primitives = {"cube \"a\"", "ball\n"};
  program.facts->depth_scale = {true, 0.1, 1e300};
  program.facts->model = {"dir/model.csg", 2, 1, 0, 0, 12};
  program.facts->compile = {"auto", "field", 8, 4, 0.3, 1, 2, 2, 1, 3, {"shadow", "fog, thick"}};
  isa::Segment segment{.region = {1, 0, 7, 4}, .instructions = {}};
  *segment.facts = {2, 12, 1, 9, 4};
  const auto add = [&](const isa::Instruction& instruction) { segment.instructions.push_back(instruction); };
  add({Opcode::enable_all, {}, {}, 0, {}});
  add({Opcode::set_constant, {{{8, 8}}}, {}, 255, {}});
  add({Opcode::keep_max, {{{0, 8}}}, {12, -7, 991, 20, 4}, 0, {Purpose::render, 0, isa::no_node}});
  add({Opcode::linear_ge, {{{0, 8}}}, {-1, 1, -300, 12, 0}, 0, {Purpose::classify, 0, 1}});
  add({Opcode::edge_negative, {}, {}, 0, {Purpose::classify, isa::no_primitive, 1}});
  segment.instructions.back().linear.width = 1;
  add({Opcode::bit_and_not, {{{16, 1}, {16, 1}, {39, 1}}}, {}, 0, {Purpose::stack, 1, isa::no_node}});
  add({Opcode::copy, {{{8, 8}, {0, 8}}}, {}, 0, {Purpose::merge, 1, isa::no_node}});
  add({Opcode::skip_if_none, {}, {}, 1, {Purpose::merge, 1, isa::no_node}});
  add({Opcode::global_or, {}, {}, 0, {Purpose::merge, 1, isa::no_node}});
  program.segments = {segment, {{0, 3, 1, 1}, {}}};
  return program;
}

/// Text of the InputError that the call throws; empty if it throws none.
template <class Call>
std::string refusal(const Call& call) {
  try {
    call();
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace csgsim::test
