// How a node divides where the half-spaces of the segment stay with the display processor.

#include <algorithm>
#include <utility>
#include <vector>

#include "hw/division/divide.h"
#include "hw/division/encoding.h"
#include "hw/multi_processor/node.h"
#include "hw/multi_processor/test_clocks.h"

namespace csgsim::multi_processor {

/// Reads each half-space that is tested, and makes the list as it goes on.
class Node::FarDatapath final : public division::Datapath {
 public:
  explicit FarDatapath(Node& node)
      : Datapath(node.records_.model()), node_(node), each_(with_unpacking(node.records_.format(), node.figures_)) {}

 private:
  division::PrimitiveHead read_primitive(std::uint32_t primitive) override {
    return node_.records_.model().primitives[primitive];
  }
  division::Halfspace read_halfspace(std::uint32_t primitive, std::uint32_t number) override {
    read_ = node_.read_halfspace({primitive, number});
    return read_.halfspace;
  }
  division::Plane read_plane(std::uint32_t /*index*/) override { return read_.plane; }

  void on_box() override { spend(each_.primitive); }
  void on_corner_test(bool /*is_last*/) override { spend(each_.halfspace); }
  void on_cell(std::uint64_t halfspaces) override { spend(halfspaces * each_.cell); }
  void on_node() override { spend(each_.tree_node); }
  void on_instruction(const isa::Instruction& instruction) override {
    node_.put(instruction);
    spend(each_.instruction);
  }

  void spend(std::uint64_t clocks) { node_.go_on(clocks); }

  Node& node_;
  const TestClocks each_;
  ReadHalfspace read_;
};

/// From the beginning of the node's turn to its list's end, which all render before the next divides.
void Node::divide_from_afar() {
  own_.begin(room_for_lists());
  divides_from_ = time_.now();
  stays_.change(NodeActivity::pruning, divides_from_);
  put(isa::SegmentStart{parts_[number_]});
  FarDatapath path(*this);
  tests_ += division::Divider(records_.model()).divide(parts_[number_], records_.left(), path).counts();
  put(isa::SegmentEnd{});
  send_made();
}

void Node::put(const isa::Command& command) {
  if (!own_.has_room_for(command)) {
    send_made();
    divides_from_ = time_.now();
    stays_.change(NodeActivity::pruning, divides_from_);
  }
  own_.put(command);
}

/// And has it rendered.
void Node::send_made() {
  divided_in_turn_ += time_.now() - divides_from_;
  while (own_.is_waiting()) {
    send_list();
    wait(message_ended_);
    render_lists();
  }
}

ReadHalfspace Node::read_halfspace(const HalfspaceName& name) {
  const std::vector<isa::LinkWord> words = division::to_link(records_.request_for(name), bus_width_);
  asks_ = true;
  const std::uint64_t begun = time_.now();
  for (std::size_t i = 0; i < words.size(); ++i) send_word(WordKind::request, words[i], i + 1 == words.size());
  while (asks_) wait(answered_);
  divides_from_ = time_.now();
  go_on(turns_since(begun));
  return records_.halfspace_of(std::exchange(answer_, {}).take());
}

/// Clocks of turns of the screen since that one, in which it stood still as the bus went on.
std::uint64_t Node::turns_since(std::uint64_t begun) {
  std::uint64_t clocks = 0;
  for (std::uint64_t at = begun; at < time_.now();) {
    const std::uint64_t left = time_.now() - at;
    const std::uint64_t free = screen_.free_from(at, left);
    const std::uint64_t turn = free > 0 ? 0 : std::min(left, screen_.left_from(at));
    clocks += turn;
    at += free + turn;
  }
  return clocks;
}

void Node::take_answer(const BusRequest& sent) {
  if (!asks_) return;
  append(answer_, sent.word, bus_width_);
  if (!sent.last) return;
  asks_ = false;
  answered_.notify(sc_core::SC_ZERO_TIME);
}

}  // namespace csgsim::multi_processor
