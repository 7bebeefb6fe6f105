#include "sim/plots/drawing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace csgsim;

namespace {

/// Whole numbers from 0 to 8.
class Places {
 public:
  plots::Pixel place() { return {coordinate(), coordinate()}; }
  plots::Segment segment() { return {place(), place()}; }

 private:
  double coordinate() { return static_cast<double>(random_() % 9); }

  std::mt19937 random_{1987};
};

plots::Pixel operator-(const plots::Pixel& a, const plots::Pixel& b) { return {a.x - b.x, a.y - b.y}; }
double determinant(const plots::Pixel& a, const plots::Pixel& b) { return a.x * b.y - b.x * a.y; }

/// Where the lines meet, by Cramer's rule, is between the ends of both.
bool cross_between_ends(const plots::Segment& one, const plots::Segment& other) {
  const plots::Pixel along = one.to - one.from;
  const plots::Pixel beside = other.to - other.from;
  const double whole = determinant(along, beside);
  if (whole == 0) return false;
  const double on_one = determinant(other.from - one.from, beside) / whole;
  const double on_other = determinant(other.from - one.from, along) / whole;
  return on_one > 0 && on_one < 1 && on_other > 0 && on_other < 1;
}

/// One of 1,001 points of the segment is inside. Ends of what is inside, of such whole numbers, are a 56th apart or
/// more.
bool has_a_point_inside(const plots::Segment& segment, const plots::Box& box) {
  for (int i = 0; i <= 1000; ++i) {
    const double x = 1000 * segment.from.x + i * (segment.to.x - segment.from.x);
    const double y = 1000 * segment.from.y + i * (segment.to.y - segment.from.y);
    if (x > 1000 * box.left && x < 1000 * box.right && y > 1000 * box.top && y < 1000 * box.bottom) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("segments cross where each has the other's ends on both of its sides") {
  Places random;
  int crossings = 0;
  for (int i = 0; i < 20'000; ++i) {
    const plots::Segment one = random.segment();
    const plots::Segment other = random.segment();
    const bool expected = cross_between_ends(one, other);
    CHECK(plots::cross(one, other) == expected);
    crossings += expected ? 1 : 0;
  }
  CHECK(crossings > 1000);
}

TEST_CASE("a segment meets a box where one of its points is inside, not on the edge") {
  Places random;
  int meetings = 0;
  for (int i = 0; i < 2'000; ++i) {
    const plots::Segment segment = random.segment();
    const plots::Segment corners = random.segment();
    const plots::Box box{std::min(corners.from.x, corners.to.x), std::min(corners.from.y, corners.to.y),
                         std::max(corners.from.x, corners.to.x), std::max(corners.from.y, corners.to.y)};
    const bool expected = has_a_point_inside(segment, box);
    CHECK(plots::meets(segment, box) == expected);
    meetings += expected ? 1 : 0;
  }
  CHECK(meetings > 200);
}
