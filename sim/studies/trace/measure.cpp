#include "sim/studies/trace/measure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

#include "host/emit/facet_geometry.h"
#include "hw/base/seconds.h"
#include "sim/software/display/rows.h"
#include "sim/studies/measured_row.h"

namespace csgsim::studies {

namespace {

std::vector<software::TraceLight> lights_of(const software::TraceScene& scene, const lighting::Lighting& lighting) {
  std::vector<software::TraceLight> lights;
  for (const lighting::CameraSpaceLight& light : lighting.lights)
    lights.push_back({light.is_point, light.is_point ? scene.place_of(light.where) : scene.direction_of(light.where)});
  return lights;
}

/// Whether each primitive is subtracted by an odd number of operators.
std::vector<bool> taken_away(const software::Tree& tree) {
  std::vector<bool> nodes(tree.nodes.size());
  std::vector<bool> primitives(tree.leaf_of.size());
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const software::Node& node = tree.nodes[i];
    if (node.is_leaf) {
      primitives[node.primitive] = nodes[i];
      continue;
    }
    nodes[node.left] = nodes[i];
    nodes[node.right] = nodes[i] != (node.op == model::Operator::subtract);
  }
  return primitives;
}

std::vector<std::uint8_t> mirrors_of(const model::Tree& model, const software::Tree& tree,
                                     const software::TraceScene& scene, const scene::Scene& look) {
  const std::vector<bool> is_cut = taken_away(tree);
  std::vector<std::uint8_t> mirrors;
  for (const software::Facet& facet : scene.facets().facets) {
    const model::Primitive& primitive = model.primitives[facet.primitive];
    const lighting::Finish finish = lighting::make_finish(look, primitive, is_cut[facet.primitive]);
    const glm::dvec3& normal = scene.geometry().planes.planes()[facet.halfspace.plane].normal;
    const bool mirrors_it = finish.material.mirror > 0 && finish.opacity >= 1 && emit::is_flat(primitive, normal);
    mirrors.push_back(mirrors_it ? 1 : 0);
  }
  if (std::ranges::count(mirrors, 1) == 0) std::ranges::fill(mirrors, std::uint8_t{1});
  return mirrors;
}

void copy_counts(const software::SpaceBuilt& built, TraceRow& row) {
  row.cells = built.cells;
  row.entries = built.entries;
  row.references = built.references;
  row.most_facets = built.most_facets;
  row.overflows = built.overflows;
  row.splits = built.splits;
  row.overlap_tests = built.overlap_tests;
  row.directory_words = built.directory_words;
  row.bucket_words = built.bucket_words;
  row.build_operations = {built.operations};
}

void copy_counts(const software::TraceCounts& counts, TraceRow& row) {
  row.words = counts.words;
  row.items = counts.items;
  row.rays = counts.primary.rays;
  row.hit_rays = counts.primary.hits;
  row.shadow_rays = counts.shadow.rays;
  row.mirror_rays = counts.mirror.rays;
  row.rays_by_cells = fmt::format("{}", fmt::join(counts.primary.rays_by_cells, " "));
  for (const software::RaysMet* met : {&counts.primary, &counts.shadow, &counts.mirror}) {
    row.cell_visits += met->cells;
    row.facet_tests += met->tested;
    row.loose_tests += met->loose;
    row.facets_met += met->met;
    row.repeats += met->repeats;
  }
  row.evaluations = counts.classification.evaluations;
  row.list_elements = counts.classification.list_elements;
  row.projection_operations = {counts.projection};
  row.traversal_operations = {counts.traversal};
  row.intersection_operations = {counts.intersection};
  row.operations = {counts.classification.operations};
  row.shade_operations = {counts.shading};
}

void draw(const TraceSubject& subject, TraceRow& row) {
  const software::TraceScene& scene = subject.scene();
  row.primitives = subject.primitive_count();
  row.halfspaces = scene.geometry().halfspaces();
  row.polygons = scene.facets().polygon_count();
  row.loose_facets = scene.loose();
  const software::TraceOptions options = subject.options_of(row.point);
  const auto begin = std::chrono::steady_clock::now();
  const std::unique_ptr<software::Directory> directory =
      software::directory_of(row.point.directory).make(scene.shapes(), {row.point.bucket_size});
  row.wall_seconds_build = seconds_since(begin);
  const software::Traced traced = software::trace(scene, *directory, options, true);
  copy_counts(directory->built(), row);
  copy_counts(traced.counts, row);
  if (options.item_pass == software::ItemPass::list_priority) row.item_faults = subject.item_faults();
  row.wall_seconds_trace = software::measure_trace_seconds(scene, *directory, options);
  row.surfaces = software::hash_of(software::picture_of(traced));
}

}  // namespace

TraceSubject::TraceSubject(const model::Tree& model, facet::Geometry geometry, view::View view,
                           const scene::Scene& look, unsigned mirror_depth)
    : model_(model),
      geometry_(std::move(geometry)),
      view_(std::move(view)),
      tree_(software::make_tree(model, software::Shape::balanced)),
      scene_(model, geometry_, view_, tree_),
      mirror_depth_(mirror_depth),
      lights_(lights_of(scene_, lighting::make_lighting(look, view_.camera))),
      mirrors_(mirrors_of(model, tree_, scene_, look)) {}

const TraceSubject::PriorityDrawing& TraceSubject::priority_drawing() const {
  if (drawn_first_) return *drawn_first_;
  const software::DisplaySubject subject{model_, geometry_, view_, tree_, scene_.facets()};
  const software::Displayed displayed = software::display_method("list-priority/depth-buffer").run(subject, true);
  PriorityDrawing drawn;
  for (std::size_t phase = 0; phase < software::phases; ++phase) {
    if (phase != static_cast<std::size_t>(software::Phase::preprocessing))
      drawn.pass.operations += displayed.counts.operations[phase];
  }
  drawn.pass.events = displayed.counts.pixel_events;
  drawn.pass.words = displayed.counts.words.all();
  drawn.faults = displayed.faults.all();
  return drawn_first_.emplace(drawn);
}

software::TraceOptions TraceSubject::options_of(const TracePoint& point) const {
  software::TraceOptions options;
  options.facet_test = point.facet_test == "space" ? software::FacetTest::space : software::FacetTest::projected;
  if (point.item_buffer == "depth-lists") options.item_pass = software::ItemPass::depth_lists;
  if (point.item_buffer == "list-priority") {
    options.item_pass = software::ItemPass::list_priority;
    options.list_priority = priority_drawing().pass;
  }
  options.has_mailboxes = point.mailboxes == "with";
  options.has_shadows = point.cast != "primary";
  options.mirror_depth = point.cast == "mirror" ? mirror_depth_ : 0;
  options.lights = lights_;
  options.mirrors = mirrors_;
  return options;
}

TraceSeconds seconds_of(const TraceRow& row, const software::Priced& processor) {
  if (!processor.processor) return {.all = row.wall_seconds_trace};
  const auto of = [&](const OperationsCell& cell) {
    return processors::seconds(cell.operations, *processor.processor);
  };
  TraceSeconds seconds{of(row.projection_operations), of(row.traversal_operations), of(row.intersection_operations),
                       of(row.operations), of(row.shade_operations)};
  seconds.all =
      seconds.projection + seconds.traversal + seconds.intersection + seconds.classification + seconds.shading;
  return seconds;
}

double build_seconds_of(const TraceRow& row, const software::Priced& processor) {
  if (!processor.processor) return row.wall_seconds_build;
  return processors::seconds(row.build_operations.operations, *processor.processor);
}

TraceRow measure_trace(const TracePoint& point, const Inputs& inputs, const TraceSubject& subject) {
  return measured_row<TraceRow>(point, inputs, [&](TraceRow& row) { draw(subject, row); });
}

}  // namespace csgsim::studies
