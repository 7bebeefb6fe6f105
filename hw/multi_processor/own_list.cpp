#include "hw/multi_processor/own_list.h"

#include <utility>

#include "hw/base/quotient.h"
#include "hw/division/divide.h"
#include "hw/multi_processor/list_wire.h"
#include "hw/multi_processor/test_clocks.h"

namespace csgsim::multi_processor {

namespace {

/// Divides from the records in the node's memory, and records the clock in which each instruction begins.
class TimedDatapath final : public division::Datapath {
 public:
  TimedDatapath(const division::DisplayModel& model, const TestClocks& each, const ListForm& form,
                std::uint32_t number_clocks)
      : Datapath(model), model_(model), each_(each), form_(form), number_clocks_(number_clocks) {}

  [[nodiscard]] std::uint64_t now() const { return now_; }
  [[nodiscard]] const std::vector<std::uint64_t>& start_clocks() const { return start_clocks_; }
  [[nodiscard]] std::uint64_t clocks_to_put(const isa::Instruction& instruction) const {
    return uses_index(instruction, form_) ? number_clocks_ : each_.instruction;
  }

 private:
  division::PrimitiveHead read_primitive(std::uint32_t primitive) override { return model_.primitives[primitive]; }
  division::Halfspace read_halfspace(std::uint32_t primitive, std::uint32_t number) override {
    return model_.primitives[primitive].halfspaces[number];
  }
  division::Plane read_plane(std::uint32_t index) override { return model_.planes[index]; }

  void on_box() override { now_ += each_.primitive; }
  void on_corner_test(bool /*is_last*/) override { now_ += each_.halfspace; }
  void on_cell(std::uint64_t halfspaces) override { now_ += halfspaces * each_.cell; }
  void on_node() override { now_ += each_.tree_node; }
  void on_instruction(const isa::Instruction& instruction) override {
    start_clocks_.push_back(now_);
    now_ += clocks_to_put(instruction);
  }

  const division::DisplayModel& model_;
  const TestClocks each_;
  const ListForm form_;
  const std::uint32_t number_clocks_;
  std::uint64_t now_ = 0;
  std::vector<std::uint64_t> start_clocks_;
};

}  // namespace

void OwnList::begin(const isa::Region& part, const RecordReader& records, const ListForm& form,
                    std::uint64_t room_words) {
  begin(room_words);
  form_ = form;
  TimedDatapath path(records.model(), node_test_costs(records.format(), figures_), form, figures_.number_clocks);
  const division::SquareDivision divided = division::Divider(records.model()).divide(part, records.survivors(), path);
  counts_ = divided.counts();
  commands_.push_back({isa::SegmentStart{part}});
  for (std::size_t i = 0; i < divided.instructions.size(); ++i) {
    const std::uint64_t start_clock = path.start_clocks()[i];
    commands_.push_back(
        {divided.instructions[i], start_clock, start_clock + path.clocks_to_put(divided.instructions[i])});
  }
  commands_.push_back({isa::SegmentEnd{}, path.now(), path.now()});
}

void OwnList::begin(std::uint64_t room_words) {
  clear();
  form_ = {};
  room_ = room_words;
}

void OwnList::put(const isa::Command& command) {
  commands_.push_back({command});
  words_ += words_of(command);
  ++built_;
}

void OwnList::clear() {
  commands_.clear();
  counts_ = {};
  built_ = sent_ = 0;
  words_ = now_ = 0;
}

std::uint64_t OwnList::build() {
  const std::uint64_t before = now_;
  for (; built_ < commands_.size(); ++built_) {
    const Timed& next = commands_[built_];
    now_ = next.start_clock;
    if (!has_room_for(next.command)) break;
    words_ += words_of(next.command);
    now_ = next.built;
  }
  return now_ - before;
}

void OwnList::send() { words_ -= words_of(commands_[sent_++].command); }

std::uint64_t OwnList::words_of(const isa::Command& command) const {
  return quotient_up(entry_bits(command, form_), figures_.word_bits);
}

}  // namespace csgsim::multi_processor
