#include "hw/pixel_square/taps.h"

#include <utility>

#include "hw/wave/segments.h"

namespace csgsim::pixel_square {

namespace {

using wave::Number;
using wave::Tap;

constexpr unsigned renderer_bits = 8;

std::string square_name(std::size_t square, const isa::Program& program) {
  return square < program.segments.size() ? wave::corner_text(program.segments[square]) : std::string();
}

Tap either(Tap one, Tap other) {
  if (one.show == wave::Show::text) {
    one.text = [first = std::move(one.text), second = std::move(other.text)] {
      std::string shown = first();
      return shown.empty() ? second() : shown;
    };
  } else {
    one.number = [first = std::move(one.number), second = std::move(other.number)] {
      const Number shown = first();
      return shown ? shown : second();
    };
  }
  return one;
}

}  // namespace

std::vector<Tap> divider_taps(const std::string& part, const CornerDivider& divider, const isa::Program& program) {
  return {wave::text(part + ".state", [&divider] { return std::string(divider.status().state); }),
          wave::text(part + ".square",
                     [&divider, &program] {
                       const std::optional<std::size_t> square = divider.status().square;
                       return square ? square_name(*square, program) : std::string();
                     }),
          wave::number(part + ".store_fill", 32, [&divider] { return Number(divider.store().fill()); })};
}

std::vector<Tap> sender_taps(const std::string& part, const SenderStatus& status, const isa::Program& program) {
  return {wave::text(part + ".state", [&status] { return std::string(status.state); }),
          wave::text(part + ".square", [&status, &program] { return square_name(status.square, program); }),
          wave::number(part + ".renderer", renderer_bits, [&status] { return Number(status.renderer); })};
}

std::vector<Tap> frame_buffer_taps(const FrameBuffer& buffer, const isa::Program& program,
                                   const systemc::SegmentNames& names) {
  return {wave::text("frame_buffer.state",
                     [&buffer] {
                       if (buffer.served()) return std::string(name_of(SquareActivity::working));
                       return std::string(buffer.refreshed() ? name_of(SquareActivity::refreshing) : "");
                     }),
          wave::number("frame_buffer.port", renderer_bits, [&buffer] { return Number(buffer.served()); }),
          wave::text("frame_buffer.square",
                     [&buffer, &program, &names] {
                       const isa::Region& region = buffer.served_square();
                       if (!buffer.served() || region.width == 0) return std::string();
                       return square_name(names.segment_of(region), program);
                     }),
          wave::number("frame_buffer.squares", 32, [&buffer] { return Number(buffer.squares()); }),
          wave::number("frame_buffer.refreshed_row", 32, [&buffer] { return Number(buffer.refreshed()); })};
}

std::vector<Tap> merge_taps(std::vector<std::vector<Tap>> renderers) {
  std::vector<Tap> merged = std::move(renderers.front());
  for (std::size_t renderer = 1; renderer < renderers.size(); ++renderer) {
    for (std::size_t i = 0; i < merged.size(); ++i)
      merged[i] = either(std::move(merged[i]), std::move(renderers[renderer][i]));
  }
  return merged;
}

}  // namespace csgsim::pixel_square
