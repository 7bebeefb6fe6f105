#include "hw/isa/depth_scale.h"
#include "hw/isa/facts.h"
#include "hw/machines/kind.h"
#include "places.h"
#include "sim/engine/engine.h"
#include "sim/observe/frame.h"
#include "sim/session/run/run_request.h"
#include "sim/suite/data.h"
#include "sim/suite/program_text.h"
#include "sim/suite/run.h"
#include "tests/corpus/reference.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

const suite::Data& data() {
  static const suite::Data all(fs::path(CSGSIM_BINARY_DIR) / "benchmark");
  return all;
}

/// The stored Program of a case and its picture at the reference level, which executes each instruction by definition.
struct Drawn {
  isa::Program program;
  observe::Frame frame;
};

Drawn draw(const suite::Case& one) {
  const suite::Job job{&one, data().suite().stored.front(), "reference"};
  suite::Prepared prepared = suite::prepare(data(), job);
  observe::Frame frame = session::draw(prepared.program, prepared.machine, job.level).frame;
  return {std::move(prepared.program), std::move(frame)};
}

/// Pixels of a picture compared with the nearest surface of OpenSCAD's mesh.
struct Verdict {
  int covered = 0;     ///< checked pixels covered in both
  int silhouette = 0;  ///< checked pixels covered in one only
  int deep = 0;        ///< pixels covered in both whose depths differ by more than a thousandth of the mesh's diagonal
  int unjudged = 0;    ///< pixels where the mesh has different results near the pixel's centre
};

Verdict judge(const Drawn& drawn, const testing::Reference& reference) {
  const isa::DepthScale& scale = drawn.program.facts->depth_scale;
  const unsigned bits = isa::find_field(drawn.program, isa::FieldRole::depth).width;
  Verdict verdict;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    const std::uint16_t value = reference.pixels[i];
    const double depth = isa::distance_of(scale, bits, drawn.frame.depth[i]);
    const bool is_covered = value != testing::Reference::nothing;
    if (value == testing::Reference::unjudged)
      ++verdict.unjudged;
    else if (std::isfinite(depth) != is_covered)
      ++verdict.silhouette;
    else if (is_covered)
      ++(std::abs(depth - reference.depth_of(value)) > reference.diagonal / 1000 ? verdict.deep : verdict.covered);
  }
  return verdict;
}

const fs::path references = fs::path(CSGSIM_SOURCE_DIR) / "tests/benchmark/references";

}  // namespace

TEST_CASE("stored Programs show OpenSCAD's surfaces and draw the expected pictures") {
  REQUIRE(data().suite().cases.size() == 20);
  for (const suite::Case& one : data().suite().cases) {
    CAPTURE(one.name);
    const Drawn drawn = draw(one);
    const std::vector<testing::Reference> views = testing::read_references(references, one.name);
    REQUIRE(views.size() == 1);
    REQUIRE(views.front().pixels.size() == drawn.frame.depth.size());
    const Verdict verdict = judge(drawn, views.front());
    CHECK(verdict.silhouette == 0);
    CHECK(verdict.deep == 0);
    CHECK(verdict.covered > 500);
    CHECK(verdict.unjudged < verdict.covered);
    const suite::Row* const row = suite::find_row(data().expected(), one.name, data().suite().stored.front());
    REQUIRE(row != nullptr);
    CHECK(row->at("picture") == suite::hash_of(drawn.frame));
  }
}

TEST_CASE("the models compile to the stored Programs") {
  const std::string& machine = data().suite().stored.front();
  for (const suite::Case& one : data().suite().cases) {
    CAPTURE(one.name);
    INFO("if the change is intended, run traces/benchmark/renew.sh build/release/csgsim");
    const std::string stored = suite::text_of(suite::prepare(data(), {&one, machine, "functional", false}).program);
    const std::string compiled = suite::text_of(suite::prepare(data(), {&one, machine, "functional", true}).program);
    CHECK(stored.size() == compiled.size());
    CHECK((stored == compiled));
  }
}

TEST_CASE("the expected pictures are the same on every machine") {
  for (const suite::Row& row : data().expected()) {
    CAPTURE(row.name());
    CAPTURE(row.machine());
    const suite::Row* const first = suite::find_row(data().expected(), row.name(), data().suite().stored.front());
    REQUIRE(first != nullptr);
    CHECK(row.at("picture") == first->at("picture"));
  }
}
