#pragma once

#include <concepts>
#include <type_traits>

#include "hw/isa/program.h"

namespace csgsim::isa {

template <class T, class Record>
concept Any = std::same_as<std::remove_const_t<T>, Record>;

/// Calls visit(key, member) for each member of a record, in the order of the binary and text forms: the one list that
/// both write and both read.
template <Any<ArrayShape> T, class Visit>
void describe(T& shape, Visit&& visit) {
  visit("width", shape.width);
  visit("height", shape.height);
  visit("memory_bits", shape.memory_bits);
}

template <Any<DepthScale> T, class Visit>
void describe(T& depth, Visit&& visit) {
  visit("perspective", depth.perspective);
  visit("near", depth.near);
  visit("far", depth.far);
}

template <Any<ModelFacts> T, class Visit>
void describe(T& model, Visit&& visit) {
  visit("file", model.file);
  visit("primitives", model.primitives);
  visit("unions", model.unions);
  visit("differences", model.differences);
  visit("intersections", model.intersections);
  visit("halfspaces", model.halfspaces);
}

template <Any<CompileFacts> T, class Visit>
void describe(T& compile, Visit&& visit) {
  visit("strategy", compile.strategy);
  visit("colouring", compile.colouring);
  visit("background", compile.background);
  visit("z_bits", compile.z_bits);
  visit("fraction_bits", compile.fraction_bits);
  visit("edge_on_fraction", compile.edge_on_fraction);
  visit("stack_bits", compile.stack_bits);
  visit("tree_depth", compile.tree_depth);
  visit("rendered", compile.rendered);
  visit("classified", compile.classified);
  visit("depth_tests", compile.depth_tests);
  visit("effects", compile.effects);
}

/// A segment but for its instructions.
template <Any<Segment> T, class Visit>
void describe(T& segment, Visit&& visit) {
  visit("x", segment.region.x);
  visit("y", segment.region.y);
  visit("width", segment.region.width);
  visit("height", segment.region.height);
  visit("primitives", segment.primitives);
  visit("halfspaces", segment.halfspaces);
  visit("kept_primitives", segment.kept_primitives);
  visit("kept_halfspaces", segment.kept_halfspaces);
  visit("comparisons", segment.comparisons);
}

/// Calls visit(name, record) for each record of a Program that stands once.
template <Any<Program> T, class Visit>
void describe_header(T& program, Visit&& visit) {
  visit("array", program.shape);
  visit("depth", program.depth_scale);
  visit("model", program.model);
  visit("compile", program.compile);
}

}  // namespace csgsim::isa
