#include "sim/report/stories.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "hw/isa/pieces.h"
#include "sim/observe/frame.h"
#include "sim/story/story.h"

namespace csgsim::report {

namespace {

/// Rows plus columns from each pixel to the nearest pixel of another owner or outside the picture.
std::vector<std::uint32_t> distances_to_others(std::span<const std::uint32_t> owner, std::size_t width) {
  const std::size_t height = owner.size() / width;
  std::vector<std::uint32_t> distances(owner.size(), static_cast<std::uint32_t>(width + height));
  const auto shorten = [&](std::size_t at, bool is_inside, std::size_t neighbour) {
    const bool is_same = is_inside && owner[neighbour] == owner[at];
    distances[at] = std::min(distances[at], is_same ? distances[neighbour] + 1 : 1);
  };
  for (std::size_t at = 0; at < owner.size(); ++at) {
    shorten(at, at % width > 0, at - 1);
    shorten(at, at >= width, at - width);
  }
  for (std::size_t at = owner.size(); at-- > 0;) {
    shorten(at, at % width + 1 < width, at + 1);
    shorten(at, at + width < owner.size(), at + width);
  }
  return distances;
}

/// Pixels of an owner at the largest distance from other owners.
struct Farthest {
  std::uint32_t distance = 0;
  std::vector<std::size_t> pixels;
};

/// The owner of a pixel as a primitive, rather than a piece of it.
std::uint32_t primitive_seen(const isa::Facts& facts, const story::Story& story) {
  return story.owner == observe::no_owner ? story.owner : isa::primitive_of(facts, story.owner);
}

}  // namespace

std::vector<std::uint32_t> primitives_by_cost(const Json& stats) {
  const Json& primitives = stats["by_primitive"];
  std::vector<std::uint32_t> order(primitives.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return primitives[a]["clocks"] > primitives[b]["clocks"]; });
  return order;
}

std::vector<std::size_t> central_pixels(std::span<const std::uint32_t> owner, std::size_t width,
                                        std::span<const std::uint32_t> owners) {
  const std::vector<std::uint32_t> distances = distances_to_others(owner, width);
  std::map<std::uint32_t, Farthest> farthest;
  for (std::size_t at = 0; at < owner.size(); ++at) {
    Farthest& known = farthest[owner[at]];
    if (distances[at] > known.distance) known = {distances[at], {}};
    if (distances[at] == known.distance) known.pixels.push_back(at);
  }
  std::vector<std::size_t> pixels;
  for (const std::uint32_t one : owners)
    if (const auto found = farthest.find(one); found != farthest.end())
      pixels.push_back(found->second.pixels[found->second.pixels.size() / 2]);
  return pixels;
}

void add_stories(const story::Subject& subject, const machines::Machine& machine, std::span<const std::size_t> pixels,
                 Drawing& drawing, const StoryLimits& limits) {
  const std::size_t width = subject.program.shape.width;
  const story::StoryBuilder builder(subject.program, machine);
  std::size_t bytes = 0;
  std::uint64_t instructions = 0;
  for (const std::size_t pixel : pixels) {
    if (drawing.stories.size() == limits.pixels) break;
    const auto has_story = [&](const PixelStory& one) { return one.y * width + one.x == pixel; };
    if (std::ranges::any_of(drawing.stories, has_story)) continue;
    const story::Story story =
        builder.story_of(static_cast<std::uint32_t>(pixel % width), static_cast<std::uint32_t>(pixel / width));
    PixelStory text{story.x, story.y, primitive_seen(*subject.program.facts, story), story::parts_of(subject, story)};
    for (const story::TextPart& part : text.parts) bytes += part.text.size();
    for (const story::StorySegment& segment : story.segments) instructions += segment.end - segment.first;
    if ((bytes > limits.bytes || instructions > limits.instructions) && !drawing.stories.empty()) break;
    drawing.stories.push_back(std::move(text));
  }
  drawing.summary += fmt::format(" Pixels with a history on this page: {}.", drawing.stories.size());
}

}  // namespace csgsim::report
