#include "hw/isa/depth_scale.h"
#include "hw/isa/facts.h"
#include "tests/corpus/reference.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

observe::Frame draw_as(const testing::Reference& reference, const std::string& path, isa::DepthScale& scale) {
  view::Sampling sampling;
  sampling.width = reference.size;
  sampling.height = reference.size;
  const testing::Compiled compiled = testing::compile_file(path, {reference.camera, sampling, 72});
  scale = compiled.program.facts->depth_scale;
  return testing::draw(compiled.program);
}

struct Difference {
  int covered = 0;     ///< checked pixels covered in both pictures
  int silhouette = 0;  ///< checked pixels covered in one picture only
  int deep = 0;        ///< pixels covered in both whose depths differ by more than a thousandth of the diagonal
};

Difference compare(const testing::Reference& reference, const std::string& path) {
  isa::DepthScale scale{};
  const observe::Frame frame = draw_as(reference, path, scale);
  Difference difference;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    const std::uint16_t value = reference.pixels[i];
    if (value == testing::Reference::unjudged) continue;
    const double depth = isa::distance_of(scale, view::Sampling{}.z_bits, frame.depth[i]);
    const bool expected = value != testing::Reference::nothing;
    if (std::isfinite(depth) != expected) {
      ++difference.silhouette;
    } else if (expected) {
      ++difference.covered;
      if (std::abs(depth - reference.depth_of(value)) > reference.diagonal / 1000) ++difference.deep;
    }
  }
  return difference;
}

void judge(const std::string& model, const std::string& path) {
  const auto refused = testing::refused_models();
  for (const testing::Reference& reference : testing::read_references(model)) {
    CAPTURE(model);
    CAPTURE(static_cast<int>(reference.camera.projection));
    Difference difference;
    const std::string error = testing::error_of([&] { difference = compare(reference, path); });
    if (const auto reason = refused.find(model); reason != refused.end()) {
      // If this succeeds, remove the model from refused.txt; if the reason differs, update it there.
      CHECK(error.find(reason->second) != std::string::npos);
      continue;
    }
    CHECK(error.empty());
    CHECK(difference.covered > 100);
    CHECK(difference.silhouette == 0);
    CHECK(difference.deep == 0);
  }
}

}  // namespace

TEST_CASE("each model of the corpus shows the surfaces of OpenSCAD's mesh") {
  const auto models = testing::corpus_models();
  const char* name = std::getenv("CSGSIM_CORPUS_MODEL");  // a single model; all if not set
  if (name != nullptr) {
    REQUIRE(models.contains(name));
    judge(name, models.at(name));
    return;
  }
  for (const auto& [model, path] : models) judge(model, path);
}

TEST_CASE("refused.txt lists only models of the corpus") {
  const auto models = testing::corpus_models();
  for (const auto& refused : testing::refused_models()) {
    CAPTURE(refused.first);
    CHECK(models.contains(refused.first));
    CHECK(!refused.second.empty());
  }
}
