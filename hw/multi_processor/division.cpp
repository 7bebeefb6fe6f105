#include "hw/multi_processor/division.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace csgsim::multi_processor {

namespace {

/// A half-space, whatever subsegment it is named in: A, B, shift, and C at the picture's top left, modulo 2^64.
using Plane = std::tuple<std::int64_t, std::int64_t, std::uint16_t, std::uint64_t>;

Plane plane_of(const isa::Linear& linear, const isa::Region& region) {
  const std::uint64_t moved =
      static_cast<std::uint64_t>(linear.a) * region.x + static_cast<std::uint64_t>(linear.b) * region.y;
  return {linear.a, linear.b, linear.shift, static_cast<std::uint64_t>(linear.c) - moved};
}

}  // namespace

Division::Division(sc_core::sc_module_name name) : sc_core::sc_module(name) {}

void Division::begin(const isa::Program& program) {
  program_ = &program;
  numbers_.clear();
  for (std::uint32_t i = 0; i < program.segments.size(); ++i) {
    const isa::Region& region = program.segments[i].region;
    numbers_[{region.x, region.y}] = i;
  }
}

DividedSegment Division::segment(std::span<const isa::Region> subsegments) const {
  DividedSegment divided;
  std::set<Plane> planes;
  bool active = false;
  for (const isa::Region& region : subsegments) {
    const isa::Segment& part = program_->segments[number_of(region)];
    divided.halfspace_tests = std::max<std::uint64_t>(divided.halfspace_tests, part.facts.halfspaces);
    divided.primitives = std::max<std::uint64_t>(divided.primitives, part.facts.primitives);
    active = active || !part.instructions.empty();
    for (const isa::Instruction& instruction : part.instructions) {
      if (instruction.linear.width > 0) planes.insert(plane_of(instruction.linear, region));
    }
  }
  divided.primitives = active ? std::max<std::uint64_t>(divided.primitives, 1) : 0;
  divided.halfspaces = planes.size();
  return divided;
}

DividedSubsegment Division::subsegment(const isa::Region& region) const {
  const isa::Segment& part = program_->segments[number_of(region)];
  return {part.facts.halfspaces, part.instructions};
}

}  // namespace csgsim::multi_processor
