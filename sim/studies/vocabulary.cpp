#include "sim/studies/vocabulary.h"

#include <algorithm>

#include "sim/studies/csv.h"

namespace csgsim::studies {

namespace {

// The same quantity has the same heading in all studies. Columns missing here, such as hashes and data of plots, are
// shown only in tables and JSON.
constexpr report::PointColumn words[] = {
    {"model", "model"},
    {"machine", "machine"},
    {"process", "process"},
    {"method", "method"},
    {"coherence", "coherence"},
    {"shape", "tree"},
    {"reduced", "reduced"},
    {"directory", "directory"},
    {"bucket_size", "bucket"},
    {"cast", "rays cast"},
    {"facet_test", "facets tested in"},
    {"item_buffer", "item buffer"},
    {"mailboxes", "mailboxes"},
    {"memory_bits", "memory bits per pixel"},
    {"knob", "setting"},
    {"value", "value"},
    {"name", "surface"},
    {"flatness", "flatness test"},
    {"repair", "crack repair"},
    {"subdivisions", "levels"},
    {"tolerance", "tolerance, model units"},
    {"width", "width, pixels"},
    {"height", "height, pixels"},
    {"fragments", "$fn (0: as in the model)"},
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
    {"cell_visits", "cells visited"},
    {"facet_tests", "facet tests"},
    {"facets_met", "facets hit"},
    {"clock_hz", "clock rate, Hz"},
    {"clock_path", "clock limited by"},
    {"clocks", "clocks"},
    {"simulated_seconds", "simulated time, s"},
    {"frames_per_second", "frames/s"},
    {"bound_by", "limited by"},
    {"setup", "setup, clocks"},
    {"render", "render, clocks"},
    {"classify", "classify, clocks"},
    {"stack", "stack, clocks"},
    {"merge", "merge, clocks"},
    {"shade", "shade, clocks"},
    {"effect", "effect, clocks"},
    {"latency", "latency, clocks"},
    {"pixel_operations", "pixel operations"},
    {"enabled", "enabled pixel operations"},
    {"rendered", "rendered"},
    {"classified", "classified"},
    {"depth_tests", "depth tests"},
    {"classification_bits", "classification bits"},
    {"used_bits", "bits per pixel, used"},
    {"pixel_transistors", "transistors per pixel"},
    {"machine_memory_bits", "memory bits of the machine"},
    {"processors", "processors"},
    {"processor_clocks", "processor clocks"},
    {"machine_transistors", "transistors in total"},
    {"machine_mm2", "area, mm²"},
    {"frame_joules", "energy per frame, J"},
    {"utilisation", "utilization", report::Show::share},
    {"met_rays", "rays with intersections"},
    {"hit_rays", "rays that hit"},
    {"points", "points"},
    {"evaluations", "evaluations"},
    {"node_visits", "node visits"},
    {"early_outs", "early outs"},
    {"list_steps", "list steps"},
    {"list_elements", "list elements"},
    {"bucket_size", "polygons per bucket"},
    {"polygons", "polygons"},
    {"clipped_polygons", "polygons after clipping"},
    {"shared_polygons", "polygons in several cells"},
    {"crossing_tests", "polygon-polygon tests"},
    {"drawn_polygons", "visible polygons"},
    {"cells", "cells"},
    {"conflicts", "conflicts"},
    {"passes", "passes"},
    {"spans", "spans"},
    {"splits", "splits"},
    {"pixel_events", "pixel events"},
    {"words", "words"},
    {"patches", "patches"},
    {"elements", "elements"},
    {"vertices", "vertices"},
    {"most_elements", "elements held, maximum"},
    {"most_vertices", "vertices held, maximum"},
    {"most_edges", "edges held, maximum"},
    {"wrong", "wrong pixels"},
    {"wrong_depth_bits", "wrong: depth resolution"},
    {"wrong_coincident", "wrong: two coincident surfaces"},
    {"wrong_three_way", "wrong: three or more coincident"},
    {"wrong_order", "wrong: order"},
    {"unexplained", "wrong: unexplained"},
    {"colour_error", "colour error (of 255)"},
    {"depth_p999", "depth error, 99.9th percentile, model units"},
    {"depth_p999_steps", "depth error, 99.9th percentile, steps"},
    {"facet_wrong", "wrong pixels against curved surfaces"},
    {"facet_depth_p999", "depth error against curved surfaces, 99.9th percentile, model units"},
    {"picture_difference", "mean colour difference (of 255)"},
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
