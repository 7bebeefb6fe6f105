#include "sim/judges/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "hw/base/text.h"
#include "hw/isa/depth_scale.h"
#include "hw/isa/facts.h"
#include "sim/judges/explain.h"
#include "sim/judges/truth.h"

namespace csgsim::judges {

namespace {

DepthError summarise(std::vector<double> errors) {
  if (errors.empty()) return {};
  const std::size_t rank = (errors.size() * 999 + 999) / 1000 - 1;
  const auto at = errors.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(errors.begin(), at, errors.end());
  return {*std::max_element(at, errors.end()), *at};
}

/// Stands for the rounding bounds and the visibility test of judge() in compare(), which needs neither.
struct NoBounds {};

template <class Allowed, class MayShow>
Errors measure(const Truth& truth, const observe::Frame& frame, const isa::Program& program, const Allowed& allowed,
               const MayShow& may_show) {
  if (frame.width != truth.width || frame.height != truth.height) {
    throw std::invalid_argument("the picture and the truth have different sizes");
  }
  const unsigned bits = program.facts->compile.z_bits;
  const std::uint32_t farthest = static_cast<std::uint32_t>((1ULL << bits) - 1);
  Errors errors;
  errors.pixels = truth.owner.size();
  std::vector<double> model_units;
  std::vector<double> steps;
  for (std::size_t i = 0; i < truth.owner.size(); ++i) {
    [[maybe_unused]] const PixelPlace place{static_cast<std::uint32_t>(i % truth.width),
                                            static_cast<std::uint32_t>(i / truth.width)};
    const std::uint32_t expected = truth.owner[i];
    const std::uint32_t depth = frame.depth[i];
    const std::uint32_t owner = depth == farthest ? nothing : frame.owner[i];
    if (expected != nothing) ++errors.covered;
    bool wrong = true;
    if ((expected == nothing) != (owner == nothing)) {
      ++errors.silhouette;
    } else if (expected != owner) {
      ++errors.owner;
    } else {
      wrong = false;
    }
    if (!wrong && expected != nothing) {
      model_units.push_back(std::abs(isa::distance_of(program.facts->depth_scale, bits, depth) - truth.distance[i]));
      steps.push_back(std::abs(isa::depth_of(program.facts->depth_scale, bits, truth.distance[i]) - depth));
      if constexpr (!std::is_same_v<Allowed, NoBounds>) {
        const Steps may = allowed(truth.plane[i], place);
        wrong = depth < std::max<std::int64_t>(may.low, 0) || depth > std::max<std::int64_t>(may.high, 0);
        if (wrong) ++errors.depth;
      }
    }
    if constexpr (!std::is_same_v<MayShow, NoBounds>) {
      if (!wrong) continue;
      if (may_show(place, owner, depth)) {
        ++errors.explained;
      } else {
        ++errors.unexplained;
        if (!errors.first_unexplained) errors.first_unexplained = place;
      }
    }
  }
  errors.model_units = summarise(std::move(model_units));
  errors.steps = summarise(std::move(steps));
  return errors;
}

}  // namespace

Errors compare(const Truth& truth, const observe::Frame& frame, const isa::Program& program) {
  return measure(truth, frame, program, NoBounds{}, NoBounds{});
}

Errors judge(const Truth& truth, const observe::Frame& frame, const isa::Program& program, const Explainer& explainer) {
  return measure(
      truth, frame, program,
      [&](std::uint32_t plane, PixelPlace at) {
        return explainer.steps(plane, make_place(at.column, at.row, truth.width, truth.height));
      },
      [&](PixelPlace at, std::uint32_t owner, std::uint32_t depth) {
        return explainer.may_show(at.column, at.row, owner, depth);
      });
}

std::string to_text(const Errors& errors) {
  if (errors.wrong() == 0) return fmt::format("No wrong pixels. Depth error at most {:.3g} steps.", errors.steps.max);
  std::string text =
      fmt::format("{} of {} pixels {} wrong ({} at the silhouette, {} with the wrong owner, {} with the wrong depth).",
                  grouped(errors.wrong()), grouped(errors.pixels), errors.wrong() == 1 ? "is" : "are",
                  grouped(errors.silhouette), grouped(errors.owner), grouped(errors.depth));
  if (errors.explained + errors.unexplained > 0) {
    text += fmt::format(" The error bounds explain {} of them and leave {} unexplained", grouped(errors.explained),
                        grouped(errors.unexplained));
    if (errors.first_unexplained) {
      text += fmt::format(", the first at column {}, row {}", errors.first_unexplained->column,
                          errors.first_unexplained->row);
    }
    text += '.';
  }
  text += fmt::format(" Where the owner is right, the depth error is at most {:.3g} steps ({:.3g} model units),",
                      errors.steps.max, errors.model_units.max);
  text += fmt::format(" and at most {:.3g} steps ({:.3g} model units) in 99.9 % of the pixels.", errors.steps.p999,
                      errors.model_units.p999);
  return text;
}

}  // namespace csgsim::judges
