#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/software/methods/counts.h"
#include "sim/software/rays/caster.h"
#include "sim/software/survey.h"
#include "tests/oracle/pixel_oracle.h"
#include "tests/unit/software/plain_tree.h"

namespace csgsim::testing {

/// Events of a ray at one depth: from `begin` up to `end`.
struct Point {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// A ray and the points that are classified until it enters the solid.
struct RecordedRay {
  std::vector<software::Event> events;
  std::vector<Point> points;
  bool hits = false;

  [[nodiscard]] std::vector<std::uint32_t> sequence(std::size_t end) const;
  [[nodiscard]] std::size_t end() const { return points.empty() ? 0 : points.back().end; }
};

/// The rays of a picture in pixel order; `seen` is the picture drawn by the rules.
std::vector<RecordedRay> record_rays(const software::RayCaster& rays, const std::vector<Seen>& seen,
                                     software::RayCounts& counts);

software::Survey survey_rays(const std::vector<RecordedRay>& rays);

/// An evaluation of the tree after the first `end` events of a ray.
struct Evaluation {
  std::size_t ray = 0;
  std::size_t end = 0;
  bool is_anew = true;  ///< whether the primitives inserted before are removed first
};

/// Remaining evaluations of a coherence method, in order, and its own counts.
struct Coherence {
  std::vector<Evaluation> evaluations;
  std::uint64_t looked_up = 0;
  std::uint64_t list_elements = 0;
  std::uint64_t list_steps = 0;
  bool looks_up_first = false;  ///< first points are in a table
};

/// Applies the named coherence method; `width` is that of the picture.
Coherence coherence_of(const std::string& name, const std::vector<RecordedRay>& rays, std::size_t width);

/// Returns all counts except words and operations for a named traversal (standard, early-out, positional, status,
/// bit-sequential or bit-parallel) on the tree as written.
software::Counts recount_traversal(const PlainTree& tree, std::size_t primitives, const std::string& traversal,
                                   const Coherence& coherence, const std::vector<RecordedRay>& rays);

}  // namespace csgsim::testing
