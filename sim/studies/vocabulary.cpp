#include "sim/studies/vocabulary.h"

#include <algorithm>

#include "sim/studies/csv.h"

namespace csgsim::studies {

namespace {

// One word for one thing, in all studies. What is not here, hashes and what plots show, is in tables and JSON alone.
constexpr report::PointColumn words[] = {
    {"model", "model"},
    {"machine", "machine"},
    {"method", "method"},
    {"coherence", "coherence"},
    {"shape", "tree"},
    {"reduced", "reduced"},
    {"directory", "directory"},
    {"bucket_size", "bucket"},
    {"cast", "rays cast"},
    {"item_buffer", "item buffer"},
    {"mailboxes", "mailboxes"},
    {"memory_bits", "memory bits"},
    {"knob", "knob"},
    {"value", "value"},
    {"name", "surface"},
    {"flatness", "flat by"},
    {"repair", "repaired by"},
    {"subdivisions", "levels"},
    {"tolerance", "tolerance, model units"},
    {"width", "pixels a row"},
    {"height", "rows"},
    {"fragments", "$fn, 0: the model's own"},
    {"ideal", "ideal"},
    {"z_bits", "z bits"},
    {"fraction_bits", "fraction bits"},
    {"colour_bits", "colour bits"},
    {"pruning", "pruning"},
    {"colouring", "colouring"},
    {"strategy", "strategy"},
    {"stack_bits", "stack bits"},
    {"alu_bits", "ALU bits"},
    {"curves", "curves"},
    {"primitives", "primitives"},
    {"pieces", "pieces"},
    {"halfspaces", "half-spaces"},
    {"polygons", "polygons"},
    {"cells", "cells"},
    {"cell_visits", "cells looked into"},
    {"facet_tests", "facets tested"},
    {"facets_met", "facets met"},
    {"clocks", "clocks"},
    {"simulated_seconds", "seconds of drawing"},
    {"frames_per_second", "frames a second"},
    {"bound_by", "bound by"},
    {"setup", "setup"},
    {"render", "render"},
    {"classify", "classify"},
    {"stack", "stack"},
    {"merge", "merge"},
    {"shade", "shade"},
    {"effect", "effect"},
    {"latency", "latency"},
    {"pixel_operations", "pixel operations"},
    {"enabled", "of these enabled"},
    {"rendered", "rendered"},
    {"classified", "classified"},
    {"depth_tests", "depth tests"},
    {"classification_bits", "bits for the classification"},
    {"used_bits", "bits in all"},
    {"pixel_transistors", "transistors a pixel"},
    {"machine_memory_bits", "memory bits of the machine"},
    {"processors", "processors"},
    {"processor_clocks", "processor clocks"},
    {"machine_transistors", "transistors of the machine"},
    {"utilisation", "used", report::Show::share},
    {"met_rays", "rays with points"},
    {"hit_rays", "rays that hit"},
    {"points", "points"},
    {"evaluations", "evaluations"},
    {"node_visits", "node visits"},
    {"early_outs", "early outs"},
    {"list_steps", "list steps"},
    {"list_elements", "list elements"},
    {"bucket_size", "polygons a bucket"},
    {"polygons", "polygons"},
    {"clipped_polygons", "after clipping"},
    {"shared_polygons", "in several cells"},
    {"crossing_tests", "tests of polygon and polygon"},
    {"drawn_polygons", "with pixels"},
    {"cells", "cells"},
    {"conflicts", "conflicts"},
    {"passes", "passes"},
    {"spans", "spans"},
    {"splits", "splits"},
    {"pixel_events", "events at pixels"},
    {"words", "words"},
    {"patches", "patches"},
    {"elements", "elements"},
    {"vertices", "vertices"},
    {"most_elements", "most elements held"},
    {"most_vertices", "most vertices held"},
    {"most_edges", "most edges held"},
    {"wrong", "wrong pixels"},
    {"wrong_depth_bits", "of these for bits of depth"},
    {"wrong_coincident", "where two surfaces coincide"},
    {"wrong_three_way", "where more do"},
    {"wrong_order", "for their order"},
    {"unexplained", "of these unexplained"},
    {"colour_error", "colour error of 255"},
    {"depth_p999", "depth error, 99.9th percentile, model units"},
    {"depth_p999_steps", "the same in steps"},
    {"facet_wrong", "pixels off the curved surfaces"},
    {"facet_depth_p999", "depth from these, 99.9th percentile"},
    {"picture_difference", "mean colour difference of 255"},
};

}  // namespace

std::vector<report::PointColumn> page_columns(std::string_view header) {
  std::vector<report::PointColumn> columns;
  for (const std::string& key : split_cells(header)) {
    const auto* const word = std::ranges::find_if(words, [&](const auto& one) { return one.key == key; });
    if (word != std::end(words)) columns.push_back(*word);
  }
  return columns;
}

}  // namespace csgsim::studies
