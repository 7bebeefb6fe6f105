#include "sim/plots/labels.h"

#include "sim/plots/text_size.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

constexpr plots::Box area{100, 50, 700, 400};

struct Case {
  std::vector<plots::LabelRequest> requests;
  plots::Surroundings surroundings{area, {}, {}};
};

/// Points in clusters, each with its mark and a label; in some cases a line joins them.
Case random_case(std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
  };
  Case one;
  const double heap = uniform(2, 300);
  const bool joined = random() % 2 == 0;
  for (std::size_t i = 1 + random() % 60; i > 0; --i) {
    const plots::Pixel at{400 + uniform(-heap, heap), 225 + uniform(-heap, heap) / 2};
    if (joined && !one.requests.empty()) one.surroundings.segments.push_back({one.requests.back().at, at});
    one.requests.push_back({at, uniform(10, 150)});
    one.surroundings.boxes.push_back(plots::square_around(at, 4.5));
  }
  return one;
}

plots::LabelRequest request(double x, double y) { return {{x, y}, 40}; }

}  // namespace

TEST_CASE("labels overlap neither each other nor marks or lines and stay in the plot's area") {
  std::mt19937 random(1);
  int leaders = 0;
  int numbers = 0;
  for (int round = 0; round < 300; ++round) {
    CAPTURE(round);
    const Case one = random_case(random);
    const std::vector<plots::PlacedLabel> placed = plots::place_labels(one.requests, one.surroundings);
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const plots::PlacedLabel& label = placed[i];
      CHECK(plots::is_within(label.box, area));
      for (const plots::Box& box : one.surroundings.boxes) CHECK(!plots::boxes_overlap(box, label.box));
      for (const plots::Segment& segment : one.surroundings.segments)
        CHECK(!plots::segment_meets_box(segment, label.box));
      leaders += label.leader ? 1 : 0;
      numbers += label.number ? 1 : 0;
      for (std::size_t j = 0; j < placed.size(); ++j) {
        if (j == i) continue;
        CHECK(!plots::boxes_overlap(label.box, placed[j].box));
        CHECK(label.request != placed[j].request);
        if (placed[j].leader) CHECK(!plots::segment_meets_box(*placed[j].leader, label.box));
        if (label.leader && placed[j].leader) CHECK(!plots::segments_cross(*label.leader, *placed[j].leader));
      }
    }
  }
  CHECK(leaders > 100);
  CHECK(numbers > 100);
}

TEST_CASE("label placement is deterministic") {
  std::mt19937 random(2);
  for (int round = 0; round < 20; ++round) {
    const Case one = random_case(random);
    const auto first = plots::place_labels(one.requests, one.surroundings);
    const auto again = plots::place_labels(one.requests, one.surroundings);
    REQUIRE(first.size() == again.size());
    for (std::size_t i = 0; i < first.size(); ++i) CHECK(first[i].box == again[i].box);
  }
}

TEST_CASE("a single label is placed to the upper right of its point without a leader") {
  const std::vector<plots::LabelRequest> requests{request(400, 200)};
  const auto placed = plots::place_labels(requests, {area, {plots::square_around({400, 200}, 4)}, {}});
  REQUIRE(placed.size() == 1);
  CHECK(placed[0].box.left > 400);
  CHECK(placed[0].box.bottom < 200);
  CHECK(!placed[0].leader);
  CHECK(!placed[0].number);
}

TEST_CASE("the label of a point in the upper right corner is placed to its left") {
  const std::vector<plots::LabelRequest> requests{request(695, 55)};
  const auto placed = plots::place_labels(requests, {area, {}, {}});
  REQUIRE(placed.size() == 1);
  CHECK(placed[0].box.right < 695);
}

TEST_CASE("labels too wide for the area are replaced by numbers from 1") {
  const plots::Box narrow{0, 0, 60, 60};
  const std::vector<plots::LabelRequest> requests{{{30, 30}, 100}, {{30, 50}, 100}};
  const auto placed = plots::place_labels(requests, {narrow, {}, {}});
  REQUIRE(placed.size() == 2);
  CHECK(placed[0].number == 1U);
  CHECK(placed[1].number == 2U);
  CHECK(placed[0].box.right - placed[0].box.left == doctest::Approx(plots::text_width("1")));
}

TEST_CASE("of 200 labels at one point those without room are omitted") {
  const std::vector<plots::LabelRequest> requests(200, request(20, 20));
  CHECK(plots::place_labels(requests, {{0, 0, 50, 50}, {}, {}}).size() < 20);
}