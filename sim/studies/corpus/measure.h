// Points, rows and measurements of a corpus.
// Used by csgsim corpus.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/corpus/distribution.h"
#include "sim/studies/inputs.h"
#include "sim/studies/jobs.h"

namespace csgsim::studies {

/// A model of a corpus on one machine.
struct CorpusPoint {
  std::string model;
  std::string machine;

  bool operator==(const CorpusPoint&) const = default;

  static void columns(auto& point, const auto& visit) {
    visit("model", point.model);
    visit("machine", point.machine);
  }
};

/// Results of a point. If the machine cannot draw it, `reason` says why and the counts are 0.
struct CorpusRow {
  static constexpr std::size_t point_columns = 2;

  CorpusPoint point;
  Inputs inputs;
  std::uint64_t primitives = 0;
  std::uint64_t pieces = 0;  ///< number of convex pieces of the primitives
  std::uint64_t halfspaces = 0;
  std::uint32_t width = 0;            ///< pixels
  std::uint32_t height = 0;           ///< pixels
  std::uint64_t clocks = 0;           ///< clocks to draw a frame
  std::uint64_t interval_clocks = 0;  ///< between frames
  double frames_per_second = 0;
  std::string bound_by;     ///< unit that limits the frame rate; empty if the kind of machine does not report it
  std::uint64_t setup = 0;  ///< clocks of instructions with this purpose; likewise below
  std::uint64_t render = 0;
  std::uint64_t classify = 0;
  std::uint64_t stack = 0;
  std::uint64_t merge = 0;
  std::uint64_t shade = 0;
  std::uint64_t effect = 0;
  std::uint64_t latency = 0;           ///< clocks until the last instruction reaches the pixels
  std::uint64_t instructions = 0;      ///< number of executed instructions
  std::uint64_t pixel_operations = 0;  ///< sum over instructions of clocks times pixels of the region
  std::uint64_t enabled = 0;           ///< pixel operations at enabled pixels
  std::uint32_t used_bits = 0;         ///< memory bits per pixel
  std::string picture;                 ///< hash of depth, owner and colour of every pixel
  std::string reason;

  [[nodiscard]] bool is_drawn() const { return reason.empty(); }
  bool operator==(const CorpusRow&) const = default;

  static void columns(auto& row, const auto& visit) {
    CorpusPoint::columns(row.point, visit);
    Inputs::columns(row.inputs, visit);
    visit("primitives", row.primitives);
    visit("pieces", row.pieces);
    visit("halfspaces", row.halfspaces);
    visit("width", row.width);
    visit("height", row.height);
    visit("clocks", row.clocks);
    visit("interval_clocks", row.interval_clocks);
    visit("frames_per_second", row.frames_per_second);
    visit("bound_by", row.bound_by);
    visit("setup", row.setup);
    visit("render", row.render);
    visit("classify", row.classify);
    visit("stack", row.stack);
    visit("merge", row.merge);
    visit("shade", row.shade);
    visit("effect", row.effect);
    visit("latency", row.latency);
    visit("instructions", row.instructions);
    visit("pixel_operations", row.pixel_operations);
    visit("enabled", row.enabled);
    visit("used_bits", row.used_bits);
    visit("picture", row.picture);
    visit("reason", row.reason);
  }
};

/// Compiles the point and draws it at the functional level.
CorpusRow measure(const CorpusPoint& point, const Job& job);

/// A column whose distribution over the models is shown.
struct CorpusColumn {
  const char* name;     ///< name in the table
  const char* heading;  ///< heading in printed tables and pages
  double (*value)(const CorpusRow& row);
  bool adds_up = true;  ///< whether a total over models is meaningful
};

std::span<const CorpusColumn> corpus_columns();

/// Distribution of a column over the models that the machine can draw.
Distribution distribution_of(std::span<const CorpusRow> rows, const std::string& machine, const CorpusColumn& column);

/// Plots of clocks between frames and of drawing clocks against half-spaces, with a mark per model, and of the share of
/// models drawn at a given frame rate; empty if nothing was drawn.
std::vector<plots::Plot> plots_of_corpus(std::span<const CorpusRow> rows);

}  // namespace csgsim::studies
