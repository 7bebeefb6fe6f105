#include "tests/support/software_ways.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "sim/software/display/rows.h"
#include "sim/software/facets/facets.h"
#include "tests/support/usual_cases.h"

namespace csgsim::testing {

namespace {

using software::Pruning;
using software::Shape;

constexpr std::array shapes{Shape::written, Shape::left_deep, Shape::balanced};
constexpr std::array prunings{Pruning::none, Pruning::cells, Pruning::inside};

std::vector<MethodVariant> make_variants() {
  std::vector<MethodVariant> ways;
  for (const Shape shape : shapes) {
    for (const software::MethodRow* const method : software::methods()) {
      if (method->takes != software::Takes::events) {
        ways.push_back({{method, nullptr}, Pruning::none, shape});
        continue;
      }
      for (const software::CoherenceRow& coherence : software::coherences()) {
        for (const Pruning pruning : prunings) ways.push_back({{method, &coherence}, pruning, shape});
      }
    }
  }
  return ways;
}

const char* name_of(Pruning pruning) {
  switch (pruning) {
    case Pruning::none: return "none";
    case Pruning::cells: return "cells";
    case Pruning::inside: return "inside";
  }
  return "?";
}

}  // namespace

std::string to_text(const MethodVariant& way) {
  return fmt::format("{} {} {}", software::name_of(way.choice), name_of(way.pruning),
                     software::shapes()[static_cast<std::size_t>(way.shape)].name);
}

const std::vector<MethodVariant>& all_variants() {
  static const std::vector<MethodVariant> ways = make_variants();
  return ways;
}

MethodVariant variant_named(const std::string& choice, Pruning pruning, Shape shape) {
  return {software::choice_of(choice), pruning, shape};
}

SoftwareScene::SoftwareScene(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view)
    : tree_(tree), geometry_(geometry), view_(view), rays_(tree, geometry, view) {
  for (std::size_t i = 0; i < shapes.size(); ++i) trees_[i] = software::make_tree(tree, shapes[i]);
}

bool SoftwareScene::is_too_deep(const MethodVariant& way) const {
  constexpr std::uint32_t most_levels = 20;
  return way.choice.method->name.starts_with("bit-parallel") && tree(way.shape).depth() > most_levels;
}

std::unique_ptr<software::Method> SoftwareScene::make(const MethodVariant& way, bool counts) const {
  const software::Subject subject{tree_, geometry_, view_, tree(way.shape), way.pruning};
  const software::Coherent coherence =
      way.choice.coherence == nullptr ? software::Coherent::all_points : way.choice.coherence->coherence;
  return way.choice.method->make(coherence, subject, counts);
}

software::Picture SoftwareScene::draw(const MethodVariant& way, bool counts) const {
  const std::unique_ptr<software::Method> method = make(way, counts);
  return software::draw(rays_, *method);
}

std::string SoftwareScene::describe_mismatch(const MethodVariant& way, const std::vector<Seen>& expected) const {
  const software::Picture picture = draw(way);
  if (picture.seen.size() != expected.size()) return to_text(way) + ": different number of pixels";
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const software::VisibleSurface& seen = picture.seen[i];
    if (seen.depth == expected[i].depth && seen.owner == expected[i].owner) continue;
    return fmt::format("{}: pixel {}, {} has owner {} at depth {}, expected {} at {}", to_text(way), i % rays_.width(),
                       i / rays_.width(), seen.owner, seen.depth, expected[i].owner, expected[i].depth);
  }
  return "";
}

std::string SoftwareScene::describe_some_mismatch(std::uint64_t number, std::size_t ways,
                                                  const std::vector<Seen>& expected) const {
  for (std::size_t i = 0; i < ways; ++i) {
    const MethodVariant& way = all_variants()[(number * ways + i) % all_variants().size()];
    std::string fault = is_too_deep(way) ? "" : describe_mismatch(way, expected);
    if (!fault.empty()) return fault;
  }
  return "";
}

namespace {

/// First difference of the methods that draw facet by facet; a large model is drawn by only one of them.
std::string fault_of_display(const software::DisplaySubject& subject, bool is_large,
                             const std::vector<Seen>& expected) {
  for (const software::DisplayRow* const row : software::display_methods()) {
    if (!row->is_exact || row->name == "rays" || (is_large && row->name != "scan-line")) continue;
    const software::Picture picture = row->run(subject, false).picture;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const software::VisibleSurface& seen = picture.seen[i];
      if (seen.depth == expected[i].depth && seen.owner == expected[i].owner) continue;
      const std::uint32_t width = subject.view.sampling.width;
      return fmt::format("{}: pixel {}, {} has owner {} at depth {}, expected {} at {}", row->name, i % width,
                         i / width, seen.owner, seen.depth, expected[i].owner, expected[i].depth);
    }
  }
  return "";
}

}  // namespace

std::string describe_software_mismatch(const std::string& csg, const model::Tree& tree, const facet::Geometry& geometry,
                                       const view::View& view, const observe::Frame& frame) {
  constexpr std::size_t ways = 6;
  std::uint64_t number = 0;
  for (const char letter : csg) number = 31 * number + static_cast<unsigned char>(letter);
  if (number / all_variants().size() % static_cast<std::uint64_t>(cases(1, 4)) != 0) return "";
  std::vector<Seen> expected;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) expected.push_back({frame.depth[i], frame.owner[i]});
  const SoftwareScene software(tree, geometry, view);
  // Most methods are slow if rays cross hundreds of surfaces, and each ray is slow with thousands of planes.
  const bool is_large = tree.primitives.size() > 100 || view.planes.size() > 5000;
  // Facets of half a million planes take 20 s per picture, and rays through 300 solids a minute, because each solid has
  // a separate sequence and its surfaces are searched among all of them.
  if (geometry.is_faceted() && view.planes.size() <= 100'000 && tree.primitives.size() <= 250) {
    const software::Facets facets = software::facets_of(tree, geometry);
    const software::DisplaySubject subject{tree, geometry, view, software.tree(Shape::written), facets};
    std::string fault = fault_of_display(subject, is_large, expected);
    if (!fault.empty()) return fault;
  }
  return is_large ? software.describe_mismatch(variant_named("status"), expected)
                  : software.describe_some_mismatch(number % all_variants().size(), ways, expected);
}

}  // namespace csgsim::testing
