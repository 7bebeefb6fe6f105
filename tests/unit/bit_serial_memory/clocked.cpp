#include "tests/unit/bit_serial_memory/clocked.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "hw/kinds/load.h"
#include "hw/systemc/kernel.h"

namespace csgsim::testing {

namespace {

/// The list covers each design, each source of expressions and each place of E; one slot and many, in one bank and in
/// several, below and above the width of a word; slow and fast links; refreshes often and never. A slow link leaves
/// time for due refreshes, so that only a fast one makes them occur within instructions.
const std::vector<std::string> descriptions{
    "digital-bit-serial-ddr4+picture.width=8+picture.height=8+array.memory_bits=8+logic.enable=1+global_or.present=1+"
    "chips.count=1+chips.columns=64+chips.banks=1+link.word_clocks=3+link.latency=10+controller.queue=1+"
    "timing.window=ideal+timing.refresh_interval=ideal",
    "digital-bit-serial-ddr4+picture.width=13+picture.height=11+array.memory_bits=40+chips.count=2+chips.columns=8+"
    "chips.banks=3+link.width=16+link.word_clocks=5+link.latency=7+controller.queue=2+timing.refresh=30+"
    "timing.refresh_interval=700",
    "ambit-ddr4+picture.width=20+picture.height=9+array.memory_bits=37+logic.expressions=planes+chips.count=3+"
    "chips.columns=25+chips.banks=2+link.width=8+link.word_clocks=40+link.latency=300+controller.queue=1+"
    "timing.window=ideal+timing.refresh_interval=ideal+bus.bits=2",
    "simdram-ddr4+picture.width=9+picture.height=7+array.memory_bits=33+logic.expressions=trees+evaluator.degree=2+"
    "logic.enable=1+global_or.present=1+chips.count=1+chips.columns=64+chips.banks=4+timing.leaf=70+"
    "timing.global_or=33+timing.refresh=5+timing.refresh_interval=11",
    "digital-bit-serial-ddr4+picture.width=33+picture.height=5+array.memory_bits=48+logic.expressions=planes+"
    "evaluator.degree=2+logic.enable=1+global_or.present=1+chips.count=1+chips.columns=64+chips.banks=5+bus.bits=3+"
    "host.plane_bits=2+timing.column=3+timing.recovery=0+timing.window=90+timing.refresh=40+"
    "timing.refresh_interval=900",
    "ambit-ddr4+picture.width=5+picture.height=30+array.memory_bits=34+logic.expressions=trees+logic.enable=1+"
    "chips.count=1+chips.columns=8+chips.banks=1+timing.leaf=2+timing.window=200+timing.refresh=100+"
    "timing.refresh_interval=3000",
    "simdram-ddr4+picture.width=70+picture.height=3+array.memory_bits=36+chips.count=1+chips.columns=128+"
    "timing.second=60+timing.activation_gap=9+link.latency=ideal+controller.queue=3+timing.refresh=20+"
    "timing.refresh_interval=50",
};

std::vector<ClockedMemory>* build_all() {
  // Never freed, because SystemC's own objects are destroyed before static objects of this file.
  auto* const all = new std::vector<ClockedMemory>;
  for (std::size_t i = 0; i < descriptions.size(); ++i) {
    ClockedMemory& one = all->emplace_back();
    one.name = descriptions[i];
    one.machine = kinds::load(descriptions[i]);
    one.hardware = std::make_unique<bit_serial_memory::MemoryMachine>(fmt::format("memory_{}", i).c_str(), one.machine);
    one.recorder =
        std::make_unique<systemc::WaveRecorder>(fmt::format("wave_{}", i).c_str(), systemc::period_of(one.machine));
  }
  return all;
}

/// Stores the sampled values of the taps.
class Sampler final : public wave::Writer {
 public:
  Sampler(std::vector<wave::Tap> taps, std::vector<std::vector<std::string>>& values)
      : taps_(std::move(taps)), values_(values) {}

  void sample(std::uint64_t /*clock*/) override {
    for (std::size_t i = 0; i < taps_.size(); ++i) values_[i].push_back(shown(taps_[i]));
  }
  void finish() override {}

 private:
  static std::string shown(const wave::Tap& tap) {
    if (tap.text) return tap.text();
    const wave::Number number = tap.number();
    return number ? fmt::format("{}", *number) : "";
  }

  std::vector<wave::Tap> taps_;
  std::vector<std::vector<std::string>>& values_;
};

}  // namespace

const std::vector<ClockedMemory>& clocked_memories() {
  static const std::vector<ClockedMemory>& all = *build_all();
  return all;
}

const ClockedMemory& smallest_memory() { return clocked_memories().front(); }

Recording::Recording(const ClockedMemory& memory, const isa::Program& program, const std::vector<wave::Pixel>& pixels,
                     wave::Window window) {
  systemc::elaborate();
  const wave::Request request{.windows = {window}, .pixels = pixels, .tree_levels = {}, .write = nullptr};
  std::vector<wave::Tap> taps = memory.hardware->taps(program, request);
  for (const wave::Tap& tap : taps) taps_.emplace_back(tap.name, std::vector<std::string>{});
  std::vector<std::vector<std::string>> values(taps.size());
  memory.recorder->arm(std::make_unique<Sampler>(std::move(taps), values), request.windows, 0, false);
  systemc::RunListener no_listener;
  memory.hardware->run(program, no_listener);
  memory.recorder->finish();
  for (std::size_t i = 0; i < taps_.size(); ++i) taps_[i].second = std::move(values[i]);
}

const std::vector<std::string>& Recording::of(const std::string& tap) const {
  const auto found = std::ranges::find_if(taps_, [&](const auto& one) { return one.first == tap; });
  if (found == taps_.end()) throw std::out_of_range(tap);
  return found->second;
}

std::uint64_t Recording::count(const std::string& tap, const std::string& value) const {
  return static_cast<std::uint64_t>(std::ranges::count(of(tap), value));
}

std::vector<std::string> Recording::names() const {
  std::vector<std::string> all;
  for (const auto& tap : taps_) all.push_back(tap.first);
  return all;
}

}  // namespace csgsim::testing
