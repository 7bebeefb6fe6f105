#include "host/effects/rows.h"
#include "host/read/read.h"
#include "host/scene/read.h"
#include "hw/isa/colour_format.h"
#include "tests/oracle/random_model.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

constexpr std::int64_t width = 50;
constexpr std::int64_t height = 37;

struct Lattice {
  std::int64_t samples = 1;
  std::int64_t reach = 0;
};

testing::Setup setup_of(const std::string& scene, const std::string& model) {
  testing::Setup setup{{}, {}, 256};
  setup.sampling.width = width;
  setup.sampling.height = height;
  const facet::Box box = facet::make_geometry(read::read_csg_text(model, "model")).box;
  setup.camera = view::view_all({{2, -3, 1.7}, {0, 0, 0}, view::Projection::orthographic}, box, width, height);
  setup.options.scene = scene::read_scene(scene, "scene", {}, effects::sections());
  setup.options.effects = effects::all();
  return setup;
}

/// The colours of a picture after equalisation, by its definition, one pixel at a time. `nothing` is the background's
/// depth.
std::vector<std::uint32_t> equalised(const observe::Frame& before, const Lattice& lattice, unsigned colour_bits,
                                     std::uint32_t nothing) {
  std::vector<std::uint32_t> after = before.colour;
  unsigned shift = colour_bits;
  for (const unsigned bits : isa::channel_widths(colour_bits)) {
    shift -= bits;
    const std::uint32_t top = (1U << bits) - 1;
    const auto level = [&](std::int64_t x, std::int64_t y) {
      return before.colour[static_cast<std::size_t>(y * width + x)] >> shift & top;
    };
    for (std::int64_t y = 0; y < height; ++y) {
      for (std::int64_t x = 0; x < width; ++x) {
        const auto pixel = static_cast<std::size_t>(y * width + x);
        if (before.depth[pixel] == nothing) continue;
        std::uint32_t counted = 0;
        std::uint32_t below = 0;
        for (std::int64_t i = 0; i < lattice.samples * lattice.samples; ++i) {
          const std::int64_t sx = (2 * (i % lattice.samples) + 1) * width / (2 * lattice.samples);
          const std::int64_t sy = (2 * (i / lattice.samples) + 1) * height / (2 * lattice.samples);
          if (lattice.reach > 0 && std::max(std::abs(sx - x), std::abs(sy - y)) > lattice.reach) continue;
          if (before.depth[static_cast<std::size_t>(sy * width + sx)] == nothing) continue;
          ++counted;
          if (level(sx, sy) < level(x, y)) ++below;
        }
        if (counted == 0) continue;
        const std::uint32_t rank = std::min(top, (below << bits) / counted);
        after[pixel] = (after[pixel] & ~(top << shift)) | rank << shift;
      }
    }
  }
  return after;
}

/// Returns the number of pixels that the effect changes.
int check(const std::string& model, const Lattice& lattice, unsigned colour_bits, const std::string& also = "") {
  testing::Setup setup = setup_of(also, model);
  setup.options.colour_bits = colour_bits;
  const observe::Frame before = testing::draw(testing::compile_text(model, setup).program);
  setup.options.scene = scene::read_scene(
      also + fmt::format("[effects.equalise]\nsamples = {}\nreach = {}\n", lattice.samples, lattice.reach), "scene", {},
      effects::sections());
  const observe::Frame after = testing::draw(testing::compile_text(model, setup).program);
  const std::uint32_t nothing = (1U << setup.sampling.z_bits) - 1;
  const std::vector<std::uint32_t> expected = equalised(before, lattice, colour_bits, nothing);
  CHECK(after.colour == expected);
  CHECK(after.depth == before.depth);
  int changed = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) changed += expected[i] != before.colour[i] ? 1 : 0;
  return changed;
}

const std::string smooth = "[effects.smooth]\n";

}  // namespace

TEST_CASE("equalisation replaces every level by its rank among the samples") {
  int changed = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    CAPTURE(seed);
    const std::string model = testing::random_model(seed, 2 + static_cast<unsigned>(seed % 6));
    if (facet::make_geometry(read::read_csg_text(model, "model")).box.empty()) continue;
    changed += check(model, {static_cast<std::int64_t>(2 + seed), 0}, isa::max_colour_bits, smooth);
  }
  CHECK(changed > 1000);
}

TEST_CASE("equalisation with a limited reach ranks a pixel among the samples within it") {
  int changed = 0;
  for (std::uint64_t seed = 11; seed <= 16; ++seed) {
    CAPTURE(seed);
    const std::string model = testing::random_model(seed, 2 + static_cast<unsigned>(seed % 6));
    if (facet::make_geometry(read::read_csg_text(model, "model")).box.empty()) continue;
    changed += check(model, {7, static_cast<std::int64_t>(seed - 8)}, isa::max_colour_bits, smooth);
  }
  CHECK(changed > 1000);
}

TEST_CASE("equalisation with 3 to 23 colour bits matches its definition") {
  const std::string ball = "sphere($fn = 12, $fa = 12, $fs = 2, r = 5);";
  for (const unsigned bits : {3U, 4U, 8U, 16U, 23U}) {
    CAPTURE(bits);
    CHECK(check(ball, {8, 0}, bits, smooth) > 0);
  }
}

TEST_CASE("equalisation leaves a picture without visible samples unchanged") {
  const std::string far_corners =
      "cube(size = [1, 1, 1]);"
      "multmatrix([[1, 0, 0, 90], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])"
      "{ cube(size = [1, 1, 1]); }";
  CHECK(check(far_corners, {1, 0}, isa::max_colour_bits) == 0);
}

TEST_CASE("equalisation replaces levels by ranks among a 64 x 64 lattice of samples") {
  CHECK(check("sphere($fn = 12, $fa = 12, $fs = 2, r = 5);", {64, 0}, isa::max_colour_bits, smooth) > 0);
}

TEST_CASE("equalisation rejects a machine without a global OR of the whole picture") {
  const std::string cube = "cube(size = [1, 1, 1]);";
  testing::Setup setup = setup_of("[effects.equalise]\n", cube);
  const auto error = [&] { return testing::error_of([&] { testing::compile_text(cube, setup); }); };
  CHECK(error().empty());
  setup.has_global_or = false;
  CHECK(error().find("with a global OR over the whole picture, which  does not have") != std::string::npos);
  setup.machine = "scan-line";
  CHECK(error().find("which scan-line does not have; use a machine that has one, such as pixel-planes-4") !=
        std::string::npos);
}
