#include "tests/numerics/hard_case.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"

using namespace csgsim::testing;

namespace {

constexpr Projection orthographic = Projection::orthographic;
constexpr Projection perspective = Projection::perspective;

/// Adjacent blocks whose common face x = 0 contains the view axis and so passes the middle column of pixel centres.
const std::string abutting = unite({box({-8, 0, 0}, {0, 8, 8}), box({0, 0, 0}, {8, 8, 8})});

Verdict from_the_front(const std::string& csg, Projection projection, double aside = 0.0) {
  return look(csg, {{aside, -60, 4}, {0, 4, 4}, projection});
}

}  // namespace

TEST_CASE("the right of two blocks that abut in an edge-on face owns the pixels on it") {
  for (const Projection projection : {orthographic, perspective}) {
    CHECK(from_the_front(abutting, projection).wrong == 0);
    const csgsim::observe::Frame frame = picture_of(abutting, {{0, -60, 4}, {0, 4, 4}, projection});
    CHECK(frame.owner[static_cast<std::size_t>(frame.height / 2) * frame.width + frame.width / 2] == 1);
  }
}
TEST_CASE("the lower of two blocks that abut in a horizontal edge-on face owns its pixels") {
  const std::string stack = unite({box({-4, 0, -8}, {4, 8, 0}), box({-4, 0, 0}, {4, 8, 8})});
  for (const Projection projection : {orthographic, perspective}) {
    const csgsim::view::Camera camera{{0, -60, 0}, {0, 4, 0}, projection};
    CHECK(look(stack, camera).wrong == 0);
    const csgsim::observe::Frame frame = picture_of(stack, camera);
    CHECK(frame.owner[static_cast<std::size_t>(frame.height / 2) * frame.width + frame.width / 2] == 0);
  }
}
TEST_CASE("solids that touch in an edge-on face do not intersect or cut each other") {
  const std::string left = box({-8, 0, 0}, {0, 8, 8});
  const std::string right = box({0, 0, 0}, {8, 8, 8});
  for (const Projection projection : {orthographic, perspective}) {
    CHECK(from_the_front(intersect({left, right}), projection).covered == 0);
    CHECK(from_the_front(subtract({left, right}), projection).wrong == 0);
    CHECK(from_the_front(subtract({right, left}), projection).wrong == 0);
    CHECK(from_the_front(subtract({unite({left, right}), right, left}), projection).covered == 0);
  }
}
TEST_CASE("a solid seen parallel to all its side faces covers the correct pixels") {
  for (const Projection projection : {orthographic, perspective}) {
    CHECK(look(cylinder({0, 0, 0}, 9, 5, 5, 64), {{0, 0, 70}, {0, 0, 0}, projection}).wrong == 0);
    CHECK(look(cylinder({0, 0, 0}, 9, 5, 5, 7), {{0, 0, -70}, {0, 0, 0}, projection}).wrong == 0);
  }
}
TEST_CASE("faces 1e-3 to 1e-12 from edge-on are drawn within the stated error bounds") {
  std::uint64_t covered = 0;
  for (int exponent = 3; exponent <= 12; ++exponent) {
    for (const double sign : {-1.0, 1.0}) {
      const double aside = sign * 60.0 * std::pow(10.0, -exponent);
      CAPTURE(exponent);
      for (const Projection projection : {orthographic, perspective}) {
        covered += from_the_front(abutting, projection, aside).covered;
        covered += from_the_front(subtract({box({-8, 0, 0}, {8, 8, 8}), box({-2, 0, 0}, {0, 8, 8})}), projection, aside)
                       .covered;
      }
    }
  }
  CHECK(covered > 10000);
}
TEST_CASE("blocks turned to 1e-3 to 1e-12 from edge-on leave no crack and no double cover") {
  for (int exponent = 3; exponent <= 12; ++exponent) {
    const std::string turned = with_transform(rotation(0, std::pow(10.0, -exponent)), abutting);
    CAPTURE(exponent);
    for (const Projection projection : {orthographic, perspective}) {
      // Both adjacent faces are covered in the middle of the picture, whichever block owns them.
      const csgsim::view::Camera camera{{0, -60, 4}, {0, 4, 4}, projection};
      look(turned, camera);
      const csgsim::observe::Frame frame = picture_of(turned, camera);
      const std::size_t middle = static_cast<std::size_t>(frame.height / 2) * frame.width + frame.width / 2;
      for (std::size_t i = middle - 3; i <= middle + 3; ++i) CHECK(frame.owner[i] != csgsim::observe::no_owner);
    }
  }
}
TEST_CASE("a plane through the eye is edge-on for every pixel in perspective") {
  // The sloping face contains the eye.
  const std::string wedge = tetrahedron({0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8});
  const csgsim::view::Camera camera{{30, 30, -52}, {2, 2, 2}, perspective};
  CHECK(look(wedge, camera).covered > 200);
  CHECK(look(unite({wedge, box({0, 0, -4}, {8, 8, 0})}), camera).covered > 200);
}
TEST_CASE("the error of a face drawn as an edge is at most half the edge-on fraction") {
  // Faces that cross the depth range within most of a pixel, at all positions between two pixel centres.
  Look how;
  how.engines = false;
  how.sampling.edge_on_fraction = 1.0;
  const double pixel = 2.0 * std::tan(11.25 * std::numbers::pi / 180.0) * 64.0 / how.sampling.height;
  std::uint64_t wrong = 0;
  for (const double part : {0.5, 0.9, -0.9}) {
    const std::string leaning =
        with_transform(fmt::format("[[1,{},0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", part * pixel / 8.0), abutting);
    for (int place = 0; place < 20; ++place) {
      const double x = 0.05 * place * pixel;
      for (const Projection projection : {orthographic, perspective}) {
        CAPTURE(part);
        const Verdict verdict = look(leaning, {{x, -60, 4}, {x, 4, 4}, projection}, how);
        CHECK(verdict.covered > 1000);
        wrong += verdict.wrong;
      }
    }
  }
  // The bound is reached: some pixels are wrong.
  CHECK(wrong > 0);
}
TEST_CASE("a finer edge-on fraction draws steep faces as surfaces") {
  Look coarse;
  coarse.sampling.edge_on_fraction = 1.0 / 16;
  Look fine;
  fine.sampling.edge_on_fraction = 1.0 / 65536;
  for (const double lean : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
    const std::string leaning =
        with_transform(fmt::format("[[1,{},0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", lean), abutting);
    for (const Look& how : {coarse, Look{}, fine}) {
      const Verdict verdict = look(leaning, {{0.3, -60, 4}, {0.3, 4, 4}, orthographic}, how);
      CHECK(verdict.covered > 1000);
      CHECK(verdict.wrong == 0);
    }
  }
}
