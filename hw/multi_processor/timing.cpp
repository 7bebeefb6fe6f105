#include "hw/multi_processor/timing.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "hw/base/quotient.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/wire.h"
#include "hw/multi_processor/clocks.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/kind.h"
#include "hw/multi_processor/refresh.h"
#include "hw/multi_processor/regions.h"
#include "hw/multi_processor/timing_model.h"
#include "hw/multi_processor/timing_parts.h"
#include "hw/multi_processor/timing_passes.h"

namespace csgsim::multi_processor {

namespace {

using machines::ClockSpan;
using machines::Machine;

/// Optional results in addition to the account.
struct Requested {
  machines::Timeline* timeline = nullptr;     ///< blank timeline to fill, or null
  std::uint32_t segment = 0;                  ///< segment of the Program whose parts are requested
  std::vector<StartedPart>* parts = nullptr;  ///< receives these parts, unless null
};

using Met = std::span<const machines::PixelActivity>;

/// Converts clocks of a rendering that begins in clock `begin` of the frame to timeline clocks: clock 0 of a timeline
/// begins one clock after the frame, at the first possible clock edge.
ClockSpan to_timeline(const ClockSpan& span, std::uint64_t begin, const Refresh& refresh) {
  const std::uint64_t end = refresh.end_clock(begin, span.end) - 1;
  return {span.empty() ? end : refresh.end_clock(begin, span.begin + 1) - 2, end};
}

/// Steps through a frame, stage by stage.
class FrameModel {
 public:
  FrameModel(const isa::Program& program, const Machine& machine, Met pixel_activity, const Requested& requested)
      : program_(program),
        machine_(machine),
        met_(pixel_activity),
        requested_(requested),
        figures_(machines::kind_figures<Figures>(machine)),
        sizes_(read_model_sizes(program.display_model)),
        memory_(display_memory(program, sizes_, figures_)),
        colour_(program.colour),
        refresh_(isa::frame_header(program), machine) {
    counted_.nodes.resize(std::size_t{machine.array.width} * machine.array.height);
  }

  FrameClocks run() {
    receive();
    transform();
    broadcast_frame();
    for (const Subsegments parts : subsegments_by_segment(program_, machine_)) draw(parts);
    return {nodes_free_, complete()};
  }

 private:
  void receive() {
    counted_.model_words = host_words(program_, figures_.host.width);
    counted_.stages.reception = figures_.host.latency + counted_.model_words * figures_.host.word_clocks;
    display_free_ = counted_.stages.reception;
  }

  void transform() {
    if (!memory_.has_planes) return;
    counted_.stages.transformation = sizes_.planes * figures_.transform_clocks;
    display_free_ += counted_.stages.transformation;
  }

  void broadcast_frame() {
    broadcast(frame_words(sizes_, machine_.link.width));
    nodes_free_ = display_free_;
  }

  void draw(Subsegments parts) {
    const SegmentDivision division = segment_division(parts);
    ++counted_.segment_count;
    divide(division);
    const Passes passes = plan_passes(parts, sizes_, machine_);
    is_remote_ = passes.is_remote;
    form_ = passes.form;
    broadcast_segment(division);
    std::uint64_t now = display_free_;
    if (division.active) {
      ++counted_.active_segments;
      now = draw_lists(parts, passes, now);
    } else {
      now = render({}, segment_region(parts), now);
    }
    nodes_free_ = now;
  }

  /// Draws a segment from the division of its first list on. Returns the clock in which all lists are rendered.
  std::uint64_t draw_lists(Subsegments parts, const Passes& passes, std::uint64_t now) {
    now = prune(parts, passes.divided, now);
    std::vector<Piece> received;
    for (const Message& message : passes.messages) {
      now = continue_dividing(message, now);
      now += share(message.words);
      if (message.piece) received.push_back(*message.piece);
      if (!message.pauses && &message != &passes.messages.back()) continue;
      ++counted_.list_passes;
      for (const Piece& piece : received) {
        const isa::Segment& part = parts[piece.subsegment];
        const std::uint64_t start_clock = now;
        now = render(part_of(part, piece), part.region, start_clock);
        record(part, piece, start_clock, now - figures_.barrier_clocks);
      }
      received.clear();
    }
    return now;
  }

  /// The tests are counted twice if memory cannot hold the survivors.
  void divide(const SegmentDivision& division) {
    const TestClocks& each = figures_.display_tests;
    const std::uint64_t times = memory_.can_hold(division, sizes_, figures_) ? 1 : 2;
    const std::uint64_t plane = memory_.has_planes ? 0 : remote_plane_clocks(sizes_, figures_);
    const std::uint64_t clocks =
        times * (division.boxes * each.primitive + division.halfspace_tests * (each.halfspace + plane) +
                 division.cell_tests * each.cell);
    counted_.first_box_tests += times * division.boxes;
    counted_.first_halfspace_tests += times * division.halfspace_tests;
    counted_.first_cell_tests += times * division.cell_tests;
    counted_.stages.first_pruning += clocks;
    const bool ahead = figures_.divides_ahead && !is_remote_;
    display_free_ = (ahead ? display_free_ : std::max(display_free_, nodes_free_)) + clocks;
  }

  void broadcast_segment(const SegmentDivision& division) {
    const std::uint32_t width = machine_.link.width;
    const std::uint64_t commands =
        quotient_up(isa::wire_bits(isa::SegmentStart{}), width) + quotient_up(isa::wire_bits(isa::SegmentEnd{}), width);
    const std::uint64_t halfspaces = is_remote_ ? 0 : division.halfspaces;
    counted_.broadcast_primitives += division.primitives;
    counted_.broadcast_halfspaces += halfspaces;
    broadcast(commands + (division.active ? segment_words(sizes_, division.primitives, halfspaces, width) : 0));
  }

  void broadcast(std::uint64_t words) {
    counted_.broadcast_words += words;
    for (NodeClocks& node : counted_.nodes) node.add(NodeActivity::receiving, words * machine_.link.word_clocks);
    const std::uint64_t clocks = message(words);
    counted_.stages.broadcasting += clocks;
    display_free_ = std::max(display_free_, nodes_free_) + clocks;
  }

  /// Counts a message on the bus and returns its clocks.
  std::uint64_t message(std::uint64_t words) {
    counted_.bus.add(BusActivity::busy, words * machine_.link.word_clocks);
    counted_.bus.add(BusActivity::granting, machine_.link.latency);
    return machine_.link.latency + words * machine_.link.word_clocks;
  }

  /// All nodes divide at the same time, node i for clocks[i] clocks. Returns the clock in which the barrier releases
  /// them.
  std::uint64_t prune(Subsegments parts, std::span<const std::uint64_t> clocks, std::uint64_t now) {
    std::uint64_t slowest = now;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const isa::DivisionStep counts = parts[i].division->sum();
      const std::uint64_t end = refresh_.end_clock(now, clocks[i]);
      counted_.second_box_tests += counts.boxes;
      counted_.second_halfspace_tests += counts.halfspaces;
      counted_.second_cell_tests += counts.cells;
      counted_.second_tree_nodes += counts.nodes;
      counted_.nodes[i].add(NodeActivity::pruning, end - now);
      slowest = std::max(slowest, end);
    }
    counted_.stages.second_pruning += slowest - now;
    return slowest + barrier();
  }

  /// Division by a single node, which may read half-spaces over the bus.
  std::uint64_t continue_dividing(const Message& message, std::uint64_t now) {
    const ReadClocks read = read_clocks(sizes_, machine_);
    counted_.broadcast_halfspaces += message.reads;
    counted_.broadcast_words += message.reads * read.answer_words;
    counted_.shared_words += message.reads * read.request_words;
    counted_.bus.add(BusActivity::busy,
                     message.reads * (read.request_words + read.answer_words) * machine_.link.word_clocks);
    counted_.bus.add(BusActivity::granting, 2 * message.reads * machine_.link.latency);
    counted_.display.add(DisplayActivity::broadcasting, message.reads * read.answer);
    const std::uint64_t end = refresh_.end_clock(now, message.divided);
    counted_.nodes[message.node].add(NodeActivity::pruning, end - now);
    counted_.stages.second_pruning += end - now;
    return end;
  }

  std::uint64_t barrier() {
    counted_.stages.barriers += figures_.barrier_clocks;
    return figures_.barrier_clocks;
  }

  std::uint64_t share(std::uint64_t words) {
    counted_.shared_words += words;
    const std::uint64_t clocks = message(words);
    for (NodeClocks& node : counted_.nodes) node.add(NodeActivity::sharing, clocks);
    counted_.stages.sharing += clocks;
    return clocks;
  }

  [[nodiscard]] NodePixels own_pixels(const isa::Region& region, std::uint32_t node) const {
    return pixels_of_node(region, machine_.array, node / machine_.array.width, node % machine_.array.width);
  }

  std::uint64_t render(const ListPart& part, const isa::Region& region, std::uint64_t now) {
    std::uint64_t slowest = now;
    // Keyed by columns and rows of a node's pixels; if nodes branch, also by their position.
    std::map<std::array<std::uint32_t, 4>, std::uint64_t> known;
    const RenderingClocks rendering(part, machine_);
    for (std::uint32_t i = 0; i < counted_.nodes.size(); ++i) {
      const NodePixels own = own_pixels(region, i);
      const bool is_alike = part.pixel_activity == nullptr;
      const auto [one, is_new] =
          known.try_emplace({own.columns, own.rows, is_alike ? 0 : own.first_x, is_alike ? 0 : own.first_y});
      if (is_new) one->second = refresh_.end_clock(now, rendering.all(own, colour_));
      counted_.nodes[i].add(NodeActivity::rendering, one->second - now);
      slowest = std::max(slowest, one->second);
    }
    counted_.stages.rendering += slowest - now;
    return slowest + barrier();
  }

  [[nodiscard]] std::uint32_t number_of(const isa::Segment& segment) const {
    return static_cast<std::uint32_t>(&segment - program_.segments.data());
  }

  [[nodiscard]] ListPart part_of(const isa::Segment& segment, const Piece& piece) const {
    return {.instructions = std::span(segment.instructions).subspan(piece.first, piece.count),
            .begins = piece.first == 0,
            .ends = piece.ends,
            .pixel_activity = met_.empty() ? nullptr : &met_[number_of(segment)],
            .first = piece.first,
            .form = form_};
  }

  /// Records the clocks in which the piece is rendered.
  void record(const isa::Segment& segment, const Piece& piece, std::uint64_t begin, std::uint64_t end) {
    const std::uint32_t number = number_of(segment);
    const ListPart part = part_of(segment, piece);
    if (requested_.parts != nullptr && number == requested_.segment) requested_.parts->push_back({part, begin, end});
    if (requested_.timeline == nullptr || piece.count == 0) return;
    const auto widen = [](ClockSpan& whole, const ClockSpan& one) {
      whole.begin = whole.empty() ? one.begin : std::min(whole.begin, one.begin);
      whole.end = std::max(whole.end, one.end);
    };
    std::vector<ClockSpan>& issued = requested_.timeline->issued[number];
    const RenderingClocks rendering(part, machine_);
    for (std::uint32_t i = 0; i < counted_.nodes.size(); ++i) {
      const NodePixels own = own_pixels(segment.region, i);
      if (own.count() == 0) continue;
      if (part.begins)
        widen(requested_.timeline->cleared[number], to_timeline({0, clearing_clocks(own, machine_)}, begin, refresh_));
      const auto first = rendering.spans_at(own, 0, 0);
      const auto last = rendering.spans_at(own, own.columns - 1, own.rows - 1);
      for (std::size_t index = 0; index < first.size(); ++index)
        widen(issued[piece.first + index], to_timeline({first[index].begin, last[index].end}, begin, refresh_));
    }
  }

  static isa::Region segment_region(Subsegments parts) {
    const isa::Region& first = parts.front().region;
    const isa::Region& last = parts.back().region;
    return {first.x, first.y, last.x + last.width - first.x, last.y + last.height - first.y};
  }

  FrameAccount complete() {
    const auto rest = [this](auto& clocks, auto waiting) { clocks.add(waiting, nodes_free_ - clocks.total()); };
    counted_.display.add(DisplayActivity::receiving, counted_.stages.reception);
    counted_.display.add(DisplayActivity::transforming, counted_.stages.transformation);
    counted_.display.add(DisplayActivity::dividing, counted_.stages.first_pruning);
    counted_.display.add(DisplayActivity::broadcasting, counted_.stages.broadcasting);
    rest(counted_.display, DisplayActivity::waiting_for_nodes);
    rest(counted_.bus, BusActivity::idle);
    for (NodeClocks& node : counted_.nodes) rest(node, NodeActivity::waiting);
    return counted_;
  }

  const isa::Program& program_;
  const Machine& machine_;
  const Met met_;
  const Requested requested_;
  const Figures& figures_;
  const ModelSizes sizes_;
  const DisplayMemory memory_;
  isa::Field colour_;
  const Refresh refresh_;
  FrameAccount counted_;
  ListForm form_;
  bool is_remote_ = false;          ///< half-spaces of the current segment stay with the display processor
  std::uint64_t display_free_ = 0;  ///< clock in which the display processor has sent what it has divided
  std::uint64_t nodes_free_ = 0;    ///< clock in which the nodes have rendered the segment
};

/// Form of the subsegment's list, if it is rendered in one pass.
std::optional<ListForm> form_of_whole(const isa::Program& program, const Machine& machine, std::uint32_t segment) {
  const isa::Segment* const part = &program.segments[segment];
  const ModelSizes sizes = read_model_sizes(program.display_model);
  for (const Subsegments parts : subsegments_by_segment(program, machine)) {
    if (part < parts.data() || part >= parts.data() + parts.size()) continue;
    const Passes passes = plan_passes(parts, sizes, machine);
    const auto is_of_part = [&](const Message& message) {
      return message.piece && &parts[message.piece->subsegment] == part;
    };
    if (std::ranges::count_if(passes.messages, is_of_part) > 1) return std::nullopt;
    return passes.form;
  }
  return ListForm{};
}

}  // namespace

FrameClocks time_stages(const isa::Program& program, const Machine& machine, Met pixel_activity) {
  check_fits(program, machine);
  return FrameModel(program, machine, pixel_activity, {}).run();
}

std::vector<StartedPart> started_parts(const isa::Program& program, const Machine& machine, std::uint32_t segment,
                                       Met pixel_activity) {
  std::vector<StartedPart> parts;
  FrameModel(program, machine, pixel_activity, {.segment = segment, .parts = &parts}).run();
  return parts;
}

machines::FrameTiming Kind::time(const isa::Program& program, const Machine& machine,
                                 const machines::RunOutcome& outcomes) const {
  const FrameClocks timing = time_stages(program, machine, outcomes.pixel_activity);
  return {.clocks = timing.clocks, .account = account(timing.account, machine.array)};
}

std::optional<machines::Timeline> Kind::timeline(const isa::Program& program, const Machine& machine,
                                                 const machines::RunOutcome& outcomes) const {
  check_fits(program, machine);
  machines::Timeline timeline = machines::blank_timeline(program);
  timeline.pixel_activity.assign(outcomes.pixel_activity.begin(), outcomes.pixel_activity.end());
  FrameModel(program, machine, timeline.pixel_activity, {.timeline = &timeline}).run();
  return timeline;
}

std::vector<machines::ClockSpan> Kind::spans_at_pixel(const machines::Timeline& timeline, const isa::Program& program,
                                                      const Machine& machine, std::uint32_t segment, std::uint32_t x,
                                                      std::uint32_t y) const {
  const isa::Segment& part = program.segments[segment];
  const isa::ArrayShape& nodes = machine.array;
  const NodePixels own = pixels_of_node(part.region, nodes, y % nodes.height, x % nodes.width);
  const std::uint32_t column = (x - part.region.x - own.first_x) / nodes.width;
  const std::uint32_t row = (y - part.region.y - own.first_y) / nodes.height;
  const Refresh refresh(isa::frame_header(program), machine);
  std::vector<StartedPart> parts;
  if (const std::optional<ListForm> form = form_of_whole(program, machine, segment)) {
    // The timeline contains the first clock in which a node executes the list.
    const machines::PixelActivity* const pixel_activity =
        timeline.pixel_activity.empty() ? nullptr : &timeline.pixel_activity[segment];
    parts.push_back({{.instructions = part.instructions, .pixel_activity = pixel_activity, .form = *form},
                     timeline.cleared[segment].begin + 1,
                     0});
  } else {
    parts = started_parts(program, machine, segment, timeline.pixel_activity);
  }
  std::vector<ClockSpan> all;
  for (const StartedPart& one : parts) {
    const RenderingClocks rendering(one.part, machine);
    for (const ClockSpan& span : rendering.spans_at(own, column, row))
      all.push_back(to_timeline(span, one.begin, refresh));
  }
  return all;
}

}  // namespace csgsim::multi_processor
