#include <chrono>
#include <cstdint>
#include <memory>

#include "hw/base/seconds.h"
#include "sim/software/display/common.h"
#include "sim/software/display/rows.h"
#include "sim/software/draw.h"
#include "sim/software/methods/rows.h"
#include "sim/software/rays/caster.h"

namespace csgsim::software {

namespace {

/// Counts transforming the half-spaces into the picture, like the planes of facets.
void count_planes(const facet::Geometry& geometry, Counting& count) {
  const std::uint64_t planes = geometry.halfspaces();
  constexpr std::uint64_t words_of_product = 4;
  constexpr std::uint64_t digits = 2;
  count(Operation::multiply, (16 * words_of_product + 3 * digits) * planes);
  count(Operation::divide, 3 * digits * planes);
  count(Operation::add_long, (12 * words_of_product + 3 * digits) * planes);
  count(Operation::load_long, 20 * planes);
  count(Operation::store_long, 6 * planes);
  count(Operation::call, planes);
  count(Operation::come_back, planes);
}

Displayed run_rays(const DisplaySubject& subject, bool counts) {
  Displayed result;
  const auto begin = std::chrono::steady_clock::now();
  const RayCaster rays(subject.model, subject.geometry, subject.view);
  const Subject classified{subject.model, subject.geometry, subject.view, subject.tree};
  const std::unique_ptr<Method> method = make_method(choice_of("status/list-structure"), classified, counts);
  RayCounts of_rays;
  result.picture = draw(rays, *method, counts ? &of_rays : nullptr);
  result.drawing_seconds = seconds_since(begin);
  const Counts of_method = method->counts();
  DisplayCounts& counted = result.counts;
  counted.polygons = counted.pieces = counted.drawn_polygons = subject.facets.polygon_count();
  counted.words.polygons = 6 * subject.geometry.halfspaces();
  counted.words.pixels = 2 * subject.pixels();
  counted.words.sequences = of_method.words;
  if (!counts) return result;
  counted.pixel_events = of_rays.events;
  counted.csg = of_method;
  Counting planes;
  count_planes(subject.geometry, planes);
  Counting pixels;
  pixels(Operation::store_long, 2 * subject.pixels());
  const auto set = [&](Phase phase, const Operations& operations) {
    counted.operations[static_cast<std::size_t>(phase)] += operations;
  };
  set(Phase::transformation, planes.done());
  set(Phase::sorting, of_rays.sorting);
  set(Phase::scan_conversion, of_rays.intersecting);
  set(Phase::scan_conversion, of_method.operations);
  set(Phase::initialisation, pixels.done());
  counted.csg.operations = {};
  for (const Operations& phase : counted.operations) counted.csg.operations += phase;
  return result;
}

}  // namespace

extern const DisplayRow rays_row{
    .name = "rays",
    .help = "no facets: intersects half-spaces ray by ray and classifies by status/list-structure",
    .source = "Jansen 1987, 4.5.3",
    .run = run_rays};

}  // namespace csgsim::software
