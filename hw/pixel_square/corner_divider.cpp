#include "hw/pixel_square/corner_divider.h"

#include <algorithm>
#include <utility>

#include "hw/division/encoding.h"
#include "hw/machines/regions.h"
#include "hw/pixel_square/commands.h"
#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

namespace {

constexpr unsigned byte_bits = 8;

}  // namespace

CornerDivider::CornerDivider(sc_core::sc_module_name name, const machines::Machine& machine)
    : Sender(name, machine, 1), machine_(machine) {}

void CornerDivider::begin(const machines::Size& picture, std::uint64_t model_bytes) {
  machines::Machine drawing = machine_;
  drawing.picture = picture;
  squares_ = machines::regions(drawing);
  picture_ = picture;
  model_bytes_ = model_bytes;
  memory_.assign(static_cast<std::size_t>(model_bytes), {});
  bits_taken_ = 0;
  divider_.reset();
  list_.reset();
  group_ = {};
  tested_.reset();
  begin_frame(squares_.size());
}

std::optional<SquareActivity> CornerDivider::prepare(std::size_t square) {
  if (!divider_) return take_model();
  if (tested_ != square) begin_tests(square);
  if (tests_left_ == 0) return std::nullopt;
  --tests_left_;
  return SquareActivity::working;
}

Square CornerDivider::take(std::size_t square) {
  return {squares_[square], commands_of(squares_[square], divided_.instructions, machine_.link.width)};
}

SquareActivity CornerDivider::take_model() {
  isa::LinkWord word;
  if (!model.nb_read(word)) return SquareActivity::waiting_for_host;
  for (unsigned i = 0; i < machine_.link.width && bits_taken_ < byte_bits * model_bytes_; ++i, ++bits_taken_) {
    memory_[static_cast<std::size_t>(bits_taken_ / byte_bits)].put(static_cast<unsigned>(bits_taken_ % byte_bits), 1,
                                                                   word.number(i, 1));
  }
  if (bits_taken_ == byte_bits * model_bytes_) divider_.emplace(division::from_link(memory_, byte_bits));
  return SquareActivity::working;
}

void CornerDivider::begin_tests(std::size_t square) {
  tested_ = square;
  tests_left_ = 0;
  const isa::Region& region = squares_[square];
  const Figures& figures = machines::own<Figures>(machine_);
  if (figures.levels == 2 && !(group_of(region) == group_)) begin_group(group_of(region));
  divided_ = list_ ? divider_->divide(region, *list_) : divider_->divide(region);
  tests_left_ += clocks_of(divided_.counts);
}

void CornerDivider::begin_group(const isa::Region& group) {
  group_ = group;
  division::Counts counts;
  list_ = divider_->survivors(group, counts);
  if (list_->entries() > machines::own<Figures>(machine_).list_entries) list_.reset();
  tests_left_ += clocks_of(counts);
}

isa::Region CornerDivider::group_of(const isa::Region& square) const {
  const std::uint32_t side = machines::own<Figures>(machine_).group_side;
  const std::uint32_t width = side * machine_.array.width;
  const std::uint32_t height = side * machine_.array.height;
  const std::uint32_t x = square.x / width * width;
  const std::uint32_t y = square.y / height * height;
  return {x, y, std::min(width, picture_.width - x), std::min(height, picture_.height - y)};
}

std::uint64_t CornerDivider::clocks_of(const division::Counts& counts) const {
  const Figures& figures = machines::own<Figures>(machine_);
  return counts.boxes * figures.box_clocks + counts.halfspaces * figures.halfspace_clocks +
         counts.cells * figures.cell_clocks + counts.nodes * figures.node_clocks;
}

}  // namespace csgsim::pixel_square
