#include "tests/numerics/curved_case.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"

using namespace csgsim::testing;

namespace {

/// A block minus the part.
std::string mould(const std::string& part) { return subtract({box({-20, -20, -20}, {20, 20, 20}), part}); }

/// A perspective picture with the near plane at a given distance.
CurvedVerdict look_from(const std::string& csg, const glm::dvec3& eye, const glm::dvec3& centre, double near = 0.25,
                        CurvedLook how = {}) {
  how.near = near;
  return look_curved(csg, {eye, centre, Projection::perspective}, how);
}

/// Draws many pictures, each with a quarter of the variants; facets are allowed where the eye is on a surface.
class Quarters {
 public:
  void look(const std::string& csg, const glm::dvec3& eye, const glm::dvec3& centre, double near = 0.25) {
    look_from(csg, eye, centre, near, how_);
    how_.share = (how_.share + 1) % how_.shares;
  }

 private:
  static CurvedLook quarter() {
    CurvedLook how;
    how.may_be_faceted = true;
    how.shares = 4;
    return how;
  }

  CurvedLook how_ = quarter();
};

void check_seen(const CurvedVerdict& verdict) {
  CHECK(verdict.covered > 100);
  CHECK(verdict.wrong <= 4);
}

const std::string cone = cylinder({0, 0, 0}, 12, 0, 6);
const std::string frustum = cylinder({0, 0, 4}, 8, 2, 6);

}  // namespace

TEST_CASE("the near plane cuts a ball around the eye open") {
  const CurvedVerdict verdict = look_from(ball({0, 0, 0}, 8), {0, -1, 0.5}, {0, 5, 0});
  CHECK(verdict.inside == 1);
  check_seen(verdict);
}
TEST_CASE("the inside of a hollow ball is seen from its middle and off-centre") {
  for (const glm::dvec3& eye : {glm::dvec3(0, 0, 0), glm::dvec3(3, -2, 1), glm::dvec3(0, 7, 0)}) {
    check_seen(look_from(mould(ball({0, 0, 0}, 8)), eye, {1, 9, 2}));
    check_seen(look_from(subtract({ball({0, 0, 0}, 10), ball({0, 0, 0}, 8)}), eye, {1, 9, 2}));
  }
}
TEST_CASE("a pipe is seen from inside along its axis and through its wall") {
  const std::string pipe = subtract({rod({0, 0, -20}, 40, 6), rod({0, 0, -21}, 42, 5)});
  check_seen(look_from(pipe, {0, 0, 0}, {0, 0, 10}));
  check_seen(look_from(pipe, {1, 2, -3}, {1, 2, 10}));
  check_seen(look_from(pipe, {1, 2, -3}, {3, 2, 10}));
  check_seen(look_from(mould(rod({0, 0, -18}, 36, 5)), {1, 2, -3}, {9, 2, 1}));
}
TEST_CASE("the near plane cuts a solid cylinder around the eye open") {
  check_seen(look_from(rod({0, 0, -20}, 40, 6), {1, 2, -3}, {9, 2, 1}));
  check_seen(look_from(rod({0, 0, -20}, 40, 6), {1, 2, -3}, {1, 2, 9}));
}
TEST_CASE("the inside of a cone is seen from its base") {
  check_seen(look_from(mould(cone), {0.5, 0.25, 11}, {0, 0, 0}));
  check_seen(look_from(mould(cone), {0, 0, 11}, {0, 0, 0}));
  check_seen(look_from(mould(cone), {0.5, 0.25, 17}, {0, 0, 0}));
}
TEST_CASE("the inside of a cone is seen from near its tip towards its base") {
  check_seen(look_from(mould(cone), {0.0625, 0.125, 1}, {0, 0, 9}, 0.0625));
  check_seen(look_from(unite({subtract({cylinder({0, 0, 0}, 14, 0, 7), cone}), box({-20, -20, 13}, {20, 20, 14})}),
                       {0.0625, 0.125, 4}, {1, 0, 9}, 0.0625));
}
TEST_CASE("the near plane cuts a solid cone around the eye open") {
  check_seen(look_from(cone, {0.5, 0.25, 6}, {0, 0, 0}));
  check_seen(look_from(cone, {0.5, 0.25, 6}, {0, 0, 9}));
  check_seen(look_from(cone, {0.5, 0.25, 6}, {9, 2, 7}));
}
TEST_CASE("an eye in the other nappe of a cone sees the tip but not that nappe") {
  check_seen(look_from(cone, {0, 0, -20}, {0, 0, 5}));
  check_seen(look_from(cone, {1, -2, -20}, {0, 0, 5}));
  check_seen(look_from(mould(cone), {1, -2, -60}, {0, 0, 5}));
}
TEST_CASE("an eye in the other nappe of a frustum looks through its narrow end") {
  check_seen(look_from(frustum, {0.5, 0.25, -6}, {0, 0, 5}));
  check_seen(look_from(mould(frustum), {0.5, 0.25, -16}, {0, 0, 5}));
  check_seen(
      look_from(subtract({cylinder({0, 0, 4}, 8, 3, 7), cylinder({0, 0, 4}, 8, 2, 6)}), {0.25, 0.125, -6}, {0, 0, 5}));
}
TEST_CASE("the inside of a hollow frustum is seen through both of its ends") {
  const std::string funnel = subtract({cylinder({0, 0, 0}, 12, 3, 9), cylinder({0, 0, -1}, 14, 1.5, 8.5)});
  check_seen(look_from(funnel, {1, 2, 40}, {0, 0, 5}));
  check_seen(look_from(funnel, {0, 0, 40}, {0, 0, 5}));
  check_seen(look_from(funnel, {0.5, 0.25, -10}, {0, 0, 5}));
  check_seen(look_from(funnel, {0.5, 0.25, 6}, {4, 3, 8}));
}
TEST_CASE("a cone with its apex at the eye is drawn by an edge test or as facets") {
  Quarters quarters;
  CurvedLook how;
  how.may_be_faceted = true;
  const CurvedVerdict verdict = look_from(cone, {0, 0, 0}, {0, 0, 9}, 1, how);
  CHECK(verdict.edges == 1);
  quarters.look(mould(cone), {0, 0, 0}, {0, 0, 9}, 1);
  quarters.look(cone, {0, 0, 0}, {1, 0, 9}, 1);
  quarters.look(frustum, {0, 0, 0}, {0, 0, 9}, 1);
  quarters.look(frustum, {0, 0, 0}, {9, 0, 0}, 1);
}
TEST_CASE("a cone with its apex nearly at the eye is drawn correctly") {
  Quarters quarters;
  for (const double off : {1e-9, 1e-6, 1e-4, 1e-2}) {
    quarters.look(frustum, {off, 0, 0}, {0, 0, 9}, 1);
    quarters.look(frustum, {off, off, -off}, {0, 0, 9}, 1);
    quarters.look(frustum, {0, 0, off}, {0, 0, 9}, 1);
  }
}
TEST_CASE("an eye on the surface of a ball or cylinder or cone sees it correctly") {
  Quarters quarters;
  quarters.look(ball({0, 0, 0}, 8), {0, -8, 0}, {0, 0, 0}, 0.25);
  quarters.look(mould(ball({0, 0, 0}, 8)), {0, -8, 0}, {0, 0, 0}, 0.25);
  quarters.look(rod({0, 0, -16}, 32, 8), {0, -8, 0}, {0, 0, 0}, 0.25);
  quarters.look(mould(rod({0, 0, -16}, 32, 8)), {0, -8, 0}, {0, 0, 4}, 0.25);
  quarters.look(mould(cone), {0, -4, 8}, {0, 0, 8}, 0.25);
}
TEST_CASE("an eye near the surface of a ball sees it correctly from either side") {
  Quarters quarters;
  for (const double off : {0x1p-4, 0x1p-12, 0x1p-20, -0x1p-4, -0x1p-12, -0x1p-20}) {
    quarters.look(ball({0, 0, 0}, 8), {0, -8 - off, 0}, {1, 0, 2}, 0.25);
    quarters.look(mould(ball({0, 0, 0}, 8)), {0, -8 - off, 0}, {1, 0, 2}, 0.25);
  }
}
TEST_CASE("the near plane cuts balls and cylinders and cones and ellipsoids open") {
  Quarters quarters;
  for (const double near : {4.0, 6.0, 8.0, 9.5}) {
    quarters.look(ball({0, 0, 0}, 4), {0, -10, 0}, {0, 0, 0}, near);
    quarters.look(rod({0, 0, -9}, 18, 4), {0, -10, 0}, {0, 0, 0}, near);
    quarters.look(rod({0, 0, -9}, 18, 4), {3, -8, 6}, {0, 0, 0}, near);
    quarters.look(with_transform(translation({0, 0, -6}), cone), {1, -10, 3}, {0, 0, 0}, near);
    quarters.look(with_transform(rotation(20, 30), with_transform(scaling({1, 2, 0.5}), ball({0, 0, 0}, 4))),
                  {0, -10, 0}, {0, 0, 0}, near);
  }
}
TEST_CASE("balls that touch the near plane are drawn correctly") {
  look_from(ball({0, 0, 0}, 4), {0, -8, 0}, {0, 0, 0}, 4);
  look_from(unite({ball({0, 0, 0}, 4), ball({0, 16, 0}, 4)}), {0, -8, 0}, {0, 0, 0}, 12);
}
TEST_CASE("solids behind the eye are invisible") {
  const CurvedVerdict verdict =
      look_from(unite({ball({0, -20, 0}, 4), ball({0, 6, 0}, 2), rod({0, -12, -30}, 60, 3)}), {0, -5, 0}, {0, 0, 0});
  CHECK(verdict.covered > 20);
}
TEST_CASE("an orthographic view shows a ball around the eye and one behind it") {
  const std::string csg = unite({ball({0, 0, 0}, 8), ball({5, -40, 5}, 4)});
  const CurvedVerdict verdict = look_curved(csg, {{0, -1, 0}, {0, 80, 0}, Projection::orthographic});
  CHECK(verdict.covered > 100);
}
