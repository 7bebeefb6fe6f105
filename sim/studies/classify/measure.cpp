#include "sim/studies/classify/measure.h"

#include "sim/software/work.h"
#include "sim/studies/measured_row.h"

namespace csgsim::studies {

namespace {

software::Choice choice_of(const ClassifyPoint& point) {
  return software::choice_of(point.coherence == "none" ? point.method : point.method + "/" + point.coherence);
}

void copy_counts(const software::Counts& counts, ClassifyRow& row) {
  row.points = counts.points;
  row.evaluations = counts.evaluations;
  row.looked_up = counts.looked_up;
  row.precomputed = counts.precomputed;
  row.pruned_nodes = counts.pruned_nodes;
  row.node_visits = counts.node_visits;
  row.early_outs = counts.early_outs;
  row.list_steps = counts.list_steps;
  row.list_elements = counts.list_elements;
  row.ties = counts.ties;
  row.words = counts.words;
  row.operations = {counts.operations};
  row.traversal_operations = {counts.traversal};
}

void copy_counts(const software::Survey& survey, ClassifyRow& row) {
  row.rays = survey.rays;
  row.met_rays = survey.met;
  row.hit_rays = survey.hits;
  row.sequences = survey.sequences;
  row.different_sequences = survey.different_sequences;
  row.combinations = survey.combinations;
  row.max_points = survey.max_points;
}

void draw(const Scene& scene, ClassifyRow& row) {
  const software::Tree tree = software::make_tree(scene.tree, software::shape_of(row.point.shape));
  const software::Subject subject{scene.tree, scene.geometry, scene.view, tree,
                                  software::pruning_of(row.point.reduced)};
  const software::RayCaster rays(scene.tree, scene.geometry, scene.view);
  const software::Work work = software::work_of(choice_of(row.point), subject, rays);
  row.primitives = scene.tree.primitives.size();
  row.halfspaces = scene.geometry.halfspaces();
  row.tree_levels = tree.depth();
  copy_counts(work.counts, row);
  if (!scene.survey) scene.survey = software::survey(rays, work.picture);
  copy_counts(*scene.survey, row);
  row.halfspace_tests = work.rays.halfspace_tests;
  row.ray_operations = {work.rays.intersecting};
  row.sort_operations = {work.rays.sorting};
  row.wall_seconds_rays = work.measured.rays;
  row.wall_seconds_classification = work.measured.classification;
  row.surfaces = software::hash_of(work.picture);
}

}  // namespace

software::PricedSeconds seconds_of(const ClassifyRow& row, const software::Priced& processor) {
  const software::Classifying classifying{row.operations.operations, row.traversal_operations.operations,
                                          choice_of(row.point).method->compiled};
  return software::seconds_of(row.ray_operations.operations, row.sort_operations.operations, classifying,
                              {row.wall_seconds_rays, row.wall_seconds_classification}, processor);
}

ClassifyRow measure(const ClassifyPoint& point, const Inputs& inputs, const Scene& scene) {
  return measured_row<ClassifyRow>(point, inputs, [&](ClassifyRow& row) { draw(scene, row); });
}

}  // namespace csgsim::studies
