#include "sim/plots/drawing.h"

#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// A segment whose ends have integer coordinates from 0 to 8.
plots::Segment random_segment(std::mt19937& random) {
  const auto place = [&] {
    const auto x = static_cast<double>(random() % 9);
    return plots::Pixel{x, static_cast<double>(random() % 9)};
  };
  const plots::Pixel from = place();
  return {from, place()};
}

/// Compares found and expected results for random pairs of segments; returns how often they are true.
template <class Found, class Expected>
int count_true(int pairs, const Found& found, const Expected& expected) {
  std::mt19937 random(1987);
  int count = 0;
  for (int i = 0; i < pairs; ++i) {
    const plots::Segment one = random_segment(random);
    const plots::Segment other = random_segment(random);
    const bool is_expected = expected(one, other);
    CHECK(found(one, other) == is_expected);
    count += is_expected ? 1 : 0;
  }
  return count;
}

/// The box with the segment as its diagonal.
plots::Box box_about(const plots::Segment& diagonal) {
  const auto [left, right] = std::minmax({diagonal.from.x, diagonal.to.x});
  const auto [top, bottom] = std::minmax({diagonal.from.y, diagonal.to.y});
  return {left, top, right, bottom};
}

plots::Pixel operator-(const plots::Pixel& a, const plots::Pixel& b) { return {a.x - b.x, a.y - b.y}; }
double determinant(const plots::Pixel& a, const plots::Pixel& b) { return a.x * b.y - b.x * a.y; }

/// Whether the lines' intersection, by Cramer's rule, lies between the ends of both.
bool cross_between_ends(const plots::Segment& one, const plots::Segment& other) {
  const plots::Pixel along = one.to - one.from;
  const plots::Pixel beside = other.to - other.from;
  const double whole = determinant(along, beside);
  if (whole == 0) return false;
  const double on_one = determinant(other.from - one.from, beside) / whole;
  const double on_other = determinant(other.from - one.from, along) / whole;
  return on_one > 0 && on_one < 1 && on_other > 0 && on_other < 1;
}

/// Whether one of 1,001 points of the segment is inside. The ends of the inside part are at least a 56th apart for such
/// integers.
bool has_a_point_inside(const plots::Segment& segment, const plots::Box& box) {
  for (int i = 0; i <= 1000; ++i) {
    const double x = 1000 * segment.from.x + i * (segment.to.x - segment.from.x);
    const double y = 1000 * segment.from.y + i * (segment.to.y - segment.from.y);
    if (x > 1000 * box.left && x < 1000 * box.right && y > 1000 * box.top && y < 1000 * box.bottom) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("segments cross exactly if each has the other's ends on both sides") {
  CHECK(count_true(20'000, plots::segments_cross, cross_between_ends) > 1000);
}

TEST_CASE("a segment meets a box if one of its points is inside and not on the edge") {
  const auto meets = [](const plots::Segment& segment, const plots::Segment& diagonal) {
    return plots::segment_meets_box(segment, box_about(diagonal));
  };
  const auto has_point = [](const plots::Segment& segment, const plots::Segment& diagonal) {
    return has_a_point_inside(segment, box_about(diagonal));
  };
  CHECK(count_true(2'000, meets, has_point) > 200);
}
