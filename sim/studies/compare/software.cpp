#include "sim/studies/compare/software.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "sim/session/options/lists.h"

namespace csgsim::studies {

namespace {

/// Memory bits of the method's data and of a depth per pixel.
std::uint64_t memory_bits(const software::Work& work, const view::Sampling& sampling) {
  constexpr std::uint64_t word = 32;
  return word * work.counts.words + std::uint64_t{sampling.z_bits} * sampling.width * sampling.height;
}

/// A part of the work and its time.
struct Part {
  const char* name;
  double seconds;
};

void set_bound(std::span<const Part> parts, double all, ComparisonRow& row) {
  const auto slowest = std::ranges::max_element(parts, {}, &Part::seconds);
  row.bound_by = slowest->name;
  row.bound_share = all > 0 ? slowest->seconds / all : 0;
}

}  // namespace

void measure_software(const ComparisonJob& job, const model::Tree& tree, ComparisonRow& row) {
  const facet::Geometry geometry = facet::make_geometry(tree, faceting_of(job.point));
  const view::View view = view::make_view(geometry, tree, job.camera, job.sampling);
  const software::Tree balanced = software::make_tree(tree, software::Shape::balanced);
  const software::Subject subject{tree, geometry, view, balanced};
  const software::RayCaster rays(tree, geometry, view);
  const software::Work work = software::work_of(job.software->choice, subject, rays);
  const software::Priced& processor = job.software->processor;
  const auto seconds_for = [&](const software::Operations& of_rays, const software::Operations& sorting,
                               const software::Classifying& classifying, const software::Seconds& measured) {
    return software::seconds_of(of_rays, sorting, classifying, measured, processor).all;
  };
  const software::Classifying classifying{work.counts.operations, work.counts.traversal,
                                          job.software->choice.method->compiled};
  const double all = seconds_for(work.rays.intersecting, work.rays.sorting, classifying, work.measured);
  const std::array parts{Part{"ray intersection", seconds_for(work.rays.intersecting, {}, {}, {work.measured.rays, 0})},
                         Part{"sorting", seconds_for({}, work.rays.sorting, {}, {})},
                         Part{"classification", seconds_for({}, {}, classifying, {0, work.measured.classification})}};
  row.primitives = tree.primitives.size();
  row.halfspaces = geometry.halfspaces();
  row.simulated_seconds = all;
  row.frames_per_second = all > 0 ? 1 / all : 0;
  row.hosted_frames_per_second = row.frames_per_second;
  if (processor.processor) {
    const double clocks = all * static_cast<double>(processor.processor->clock_hz);
    row.clocks = static_cast<std::uint64_t>(std::llround(clocks));
    row.shown_clocks = row.clocks;
    row.processor_clocks = row.clocks;
  }
  row.processors = 1;
  row.machine_memory_bits = memory_bits(work, job.sampling);
  set_bound(parts, all, row);
  row.surfaces = software::hash_of(work.picture);
}

std::vector<SoftwareChoice> parse_software_choices(const std::string& list) {
  std::vector<SoftwareChoice> choices;
  for (const std::string& word : session::parse_words(list)) {
    const std::size_t colon = word.rfind(':');
    if (colon == std::string::npos)
      throw InputError("'" + word +
                       "' is not of the form PROCESSOR:METHOD or PROCESSOR:METHOD/COHERENCE, such as "
                       "mc68000:status");
    SoftwareChoice one{{}, software::load_priced(word.substr(0, colon)), software::choice_of(word.substr(colon + 1))};
    one.name = one.processor.name + ":" + software::name_of(one.choice);
    choices.push_back(std::move(one));
  }
  return choices;
}

}  // namespace csgsim::studies
