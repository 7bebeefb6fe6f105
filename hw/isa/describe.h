// Lists the members of each record of a Program. Used in hw/isa by the binary and text forms, validation and the
// manual.
#pragma once

#include <concepts>
#include <type_traits>

#include "hw/isa/facts.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/program.h"

namespace csgsim::isa {

template <class T, class Record>
concept Any = std::same_as<std::remove_const_t<T>, Record>;

/// Calls visit(key, member) for each member of a record, in the order of the binary and text forms. Readers and writers
/// of both forms share these lists.
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

template <Any<MachineRecord> T, class Visit>
void describe(T& machine, Visit&& visit) {
  visit("name", machine.name);
  visit("kind", machine.kind);
  visit("figures", machine.figures);
}

/// The members of a Program that describe the displayed frame.
template <Any<Program> T>
struct FrameRecord {
  T& program;
};

template <class T, class Visit>
void describe(const FrameRecord<T>& record, Visit&& visit) {
  visit("colour_base", record.program.colour.base);
  visit("colour_bits", record.program.colour.width);
  visit("background", record.program.background);
}

template <Any<RowExtent> T, class Visit>
void describe(T& extent, Visit&& visit) {
  visit("first", extent.first);
  visit("last", extent.last);
}

template <Any<CompileFacts> T, class Visit>
void describe(T& compile, Visit&& visit) {
  visit("strategy", compile.strategy);
  visit("colouring", compile.colouring);
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

/// A segment without its instructions.
template <Any<Segment> T, class Visit>
void describe(T& segment, Visit&& visit) {
  visit("x", segment.region.x);
  visit("y", segment.region.y);
  visit("width", segment.region.width);
  visit("height", segment.region.height);
  visit("primitives", segment.facts->primitives);
  visit("halfspaces", segment.facts->halfspaces);
  visit("kept_primitives", segment.facts->kept_primitives);
  visit("kept_halfspaces", segment.facts->kept_halfspaces);
  visit("comparisons", segment.facts->comparisons);
}

template <Any<DivisionStep> T, class Visit>
void describe(T& step, Visit&& visit) {
  visit("boxes", step.boxes);
  visit("lists", step.lists);
  visit("tests", step.halfspaces);
  visit("cells", step.cells);
  visit("nodes", step.nodes);
  visit("instructions", step.instructions);
}

template <Any<Preparation> T, class Visit>
void describe(T& preparation, Visit&& visit) {
  visit("planes", preparation.planes);
  visit("points", preparation.points);
  visit("colours", preparation.colours);
  visit("boxes", preparation.boxes);
  visit("tests", preparation.halfspaces);
  visit("values", preparation.values);
  visit("supports", preparation.supports);
  visit("nodes", preparation.nodes);
  visit("products", preparation.products);
  visit("quotients", preparation.quotients);
}

template <Any<PruningFacts> T, class Visit>
void describe(T& pruning, Visit&& visit) {
  visit("name", pruning.name);
  visit("tried", pruning.tried);
  visit("decided", pruning.decided);
  visit("left", pruning.left);
  visit("saved", pruning.saved);
  visit("nanoseconds", pruning.nanoseconds);
}

/// The counts of a group, without the steps.
template <Any<DivisionCounts> T, class Visit>
void describe(T& division, Visit&& visit) {
  visit("group_boxes", division.group_boxes);
  visit("group_lists", division.group_lists);
  visit("group_tests", division.group_halfspaces);
  visit("group_cells", division.group_cells);
  visit("group_entries", division.group_entries);
}

/// A segment without its instructions, with the counts of its group's division.
template <Any<Segment> T>
struct DividedSegment {
  T& segment;
};

template <class T, class Visit>
void describe(const DividedSegment<T>& divided, Visit&& visit) {
  describe(divided.segment, visit);
  describe(*divided.segment.division, visit);
}

/// Calls visit(name, record) for each record that a Program contains once.
template <Any<Program> T, class Visit>
void describe_header(T& program, Visit&& visit) {
  visit("array", program.shape);
  visit("machine", program.machine);
  const FrameRecord<T> shown{program};
  visit("frame", shown);
  visit("depth", program.facts->depth_scale);
  visit("model", program.facts->model);
  visit("compile", program.facts->compile);
}

}  // namespace csgsim::isa
