// Division by a node while the half-spaces of the segment stay with the display processor.

#include <algorithm>
#include <utility>
#include <vector>

#include "hw/division/divide.h"
#include "hw/division/encoding.h"
#include "hw/multi_processor/node.h"
#include "hw/multi_processor/test_clocks.h"

namespace csgsim::multi_processor {

/// Reads each tested half-space over the bus, and meanwhile extends the list.
class Node::FarDatapath final : public division::Datapath {
 public:
  explicit FarDatapath(Node& node)
      : Datapath(node.records_.model()), node_(node), each_(node_test_costs(node.records_.format(), node.figures_)) {}

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
    node_.append_command(instruction);
    spend(each_.instruction);
  }

  void spend(std::uint64_t clocks) { node_.advance(clocks); }

  Node& node_;
  const TestClocks each_;
  ReadHalfspace read_;
};

/// Divides and sends during the node's turn, up to the end of its list; all nodes render before the next node divides.
void Node::divide_remotely() {
  own_.begin(room_for_lists());
  dividing_since_ = time_.now();
  activities_.change(NodeActivity::pruning, dividing_since_);
  append_command(isa::SegmentStart{parts_[number_]});
  FarDatapath path(*this);
  tests_ += division::Divider(records_.model()).divide(parts_[number_], records_.survivors(), path).counts();
  append_command(isa::SegmentEnd{});
  send_built();
}

void Node::append_command(const isa::Command& command) {
  if (!own_.has_room_for(command)) {
    send_built();
    dividing_since_ = time_.now();
    activities_.change(NodeActivity::pruning, dividing_since_);
  }
  own_.put(command);
}

/// Sends the commands that have been built; all nodes render them at each pause and at the end.
void Node::send_built() {
  turn_dividing_clocks_ += time_.now() - dividing_since_;
  while (own_.has_unsent()) {
    send_list();
    wait(message_ended_);
    render_lists();
  }
}

ReadHalfspace Node::read_halfspace(const HalfspaceId& id) {
  const std::vector<isa::LinkWord> words = division::to_link(records_.encode_request(id), bus_width_);
  awaiting_answer_ = true;
  const std::uint64_t start_clock = time_.now();
  for (std::size_t i = 0; i < words.size(); ++i) send_word(WordKind::request, words[i], i + 1 == words.size());
  while (awaiting_answer_) wait(answered_);
  dividing_since_ = time_.now();
  advance(screen_turn_clocks(start_clock));
  return records_.decode_halfspace(std::exchange(answer_, {}).take());
}

/// Clocks of turns of the screen since `start_clock`, in which the node stalled but the bus continued.
std::uint64_t Node::screen_turn_clocks(std::uint64_t start_clock) {
  std::uint64_t clocks = 0;
  for (std::uint64_t at = start_clock; at < time_.now();) {
    const std::uint64_t left = time_.now() - at;
    const std::uint64_t free = screen_.free_clocks_from(at, left);
    const std::uint64_t turn = free > 0 ? 0 : std::min(left, screen_.turn_clocks_left(at));
    clocks += turn;
    at += free + turn;
  }
  return clocks;
}

void Node::take_answer(const BusRequest& bus_word) {
  if (!awaiting_answer_) return;
  append_word(answer_, bus_word.word, bus_width_);
  if (!bus_word.last) return;
  awaiting_answer_ = false;
  answered_.notify(sc_core::SC_ZERO_TIME);
}

}  // namespace csgsim::multi_processor
