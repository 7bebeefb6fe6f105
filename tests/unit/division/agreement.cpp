#include "tests/unit/division/agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "host/emit/display_model.h"
#include "host/emit/division_counts.h"
#include "host/read/read.h"
#include "hw/division/encoding.h"
#include "hw/pixel_square/kind.h"
#include "tests/unit/division/hand_models.h"

namespace csgsim::testing {

namespace {

std::string show(const division::Counts& counts) {
  return fmt::format("{} boxes, {} lists, {} half-spaces, {} cells, {} nodes, {} instructions", counts.boxes,
                     counts.lists, counts.halfspaces, counts.cells, counts.nodes, counts.instructions);
}

/// Compares the host's counts with those of the divider; the last step may be empty.
std::string difference(const division::SquareDivision& divided, const isa::Segment& segment,
                       const emit::SquareCounts& square) {
  for (std::size_t i = 0; i < std::max(divided.instructions.size(), segment.instructions.size()); ++i) {
    if (i >= divided.instructions.size()) return fmt::format("the divider stops after {} instructions", i);
    if (i >= segment.instructions.size()) return fmt::format("the host stops after {} instructions", i);
    if (!(divided.instructions[i] == segment.instructions[i])) return fmt::format("instruction {} differs", i);
  }
  std::uint64_t written = 0;
  for (std::size_t i = 0; i < std::max(divided.steps.size(), square.size()); ++i) {
    division::Counts mine = i < divided.steps.size() ? divided.steps[i] : division::Counts{};
    written += std::exchange(mine.instructions, 0);
    const division::Counts host = i < square.size() ? square[i].counts : division::Counts{};
    if (!(mine == host)) return fmt::format("divider: {} in step {}; host: {}", show(mine), i, show(host));
  }
  if (written != segment.instructions.size()) return fmt::format("the divider counts {} instructions", written);
  return {};
}

std::string at(const isa::Region& square, const char* levels, const std::string& what) {
  return what.empty() ? what : fmt::format("square {},{}, {}: {}", square.x, square.y, levels, what);
}

std::string one_level(const ForDivider& made, const DivisionCase& how, ModelDivider& divider,
                      const std::vector<isa::Region>& squares, division::Counts& done) {
  const Compiled& host = made.host;
  const std::vector<emit::SquareCounts> counts =
      emit::count_division(host.tree, host.scene, host.view, how.setup.options, squares);
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const division::SquareDivision divided = divider.divide(squares[i]);
    done += divided.counts();
    std::string what = difference(divided, host.program.segments[i], counts[i]);
    if (!what.empty()) return at(squares[i], "one level", what);
  }
  return {};
}

std::string two_levels(const ForDivider& made, const DivisionCase& how, ModelDivider& divider) {
  const Compiled& host = made.host;
  const isa::ArrayShape& picture = host.program.shape;
  const std::uint32_t width = how.group_side * how.setup.square.width;
  const std::uint32_t height = how.group_side * how.setup.square.height;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<const isa::Segment*>> groups;
  for (const isa::Segment& segment : host.program.segments)
    groups[{segment.region.y / height, segment.region.x / width}].push_back(&segment);
  for (const auto& [place, segments] : groups) {
    const std::uint32_t x = place.second * width;
    const std::uint32_t y = place.first * height;
    const isa::Region group{x, y, std::min(width, picture.width - x), std::min(height, picture.height - y)};
    std::vector<isa::Region> squares;
    for (const isa::Segment* segment : segments) squares.push_back(segment->region);
    const division::DividedGroup divided = divider.divide_group(group, squares, how.list_entries);
    const emit::GroupCounts counts =
        emit::count_group_division(host.tree, host.scene, host.view, how.setup.options, group, squares);
    if (!(divided.group == counts.group))
      return at(group, "group", fmt::format("{}; the host {}", show(divided.group), show(counts.group)));
    if (divided.fits != (counts.entries <= how.list_entries)) return at(group, "group", "the list's size differs");
    if (divided.fits && divided.entries != counts.entries)
      return at(group, "group", fmt::format("{} entries; the host {}", divided.entries, counts.entries));
    const std::vector<emit::SquareCounts> whole =
        emit::count_division(host.tree, host.scene, host.view, how.setup.options, squares);
    for (std::size_t i = 0; i < squares.size(); ++i) {
      std::string what = difference(divided.squares[i], *segments[i], divided.fits ? counts.squares[i] : whole[i]);
      if (!what.empty()) return at(squares[i], "two levels", what);
    }
  }
  return {};
}

ForDivider with_display_model(Compiled host, const Setup& setup) {
  division::Bits sent =
      division::encode(emit::make_display_model(host.tree, host.scene, host.view, setup.options, setup.memory_bits));
  return {std::move(host), std::move(sent)};
}

}  // namespace

Setup squares_of(const view::Camera& camera, const view::Sampling& sampling, machines::Size square,
                 emit::Colouring colouring) {
  Setup setup;
  setup.camera = camera;
  setup.sampling = sampling;
  setup.memory_bits = 200;
  setup.kind = &pixel_square::kind;
  setup.square = square;
  setup.has_global_or = false;
  emit::Options options;
  options.colouring = colouring;
  setup.options = emit::divider_options(options);
  return setup;
}

ForDivider compile_for_divider(const std::string& text, const Setup& setup) {
  return with_display_model(compile_text(text, setup), setup);
}

ForDivider compile_file_for_divider(const std::string& path, const Setup& setup) {
  return with_display_model(compile_file(path, setup), setup);
}

std::string difference(const ForDivider& made, const DivisionCase& how, division::Counts& done) {
  ModelDivider divider(division::decode(made.sent));
  std::vector<isa::Region> squares;
  for (const isa::Segment& segment : made.host.program.segments) squares.push_back(segment.region);
  std::string what = one_level(made, how, divider, squares, done);
  return what.empty() ? two_levels(made, how, divider) : what;
}

}  // namespace csgsim::testing
