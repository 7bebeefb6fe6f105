#include "hw/pixel_planes/pixel_pipeline.h"

#include <algorithm>

#include "hw/machines/clocks.h"
#include "hw/systemc/kernel.h"

namespace csgsim::pixel_planes {

namespace {

array::PlaneShape whole_array(const machines::Machine& machine) { return {machine.array.width, machine.array.height}; }

std::optional<array::SteppedEvaluator> adders(const machines::Machine& machine, systemc::EvaluatorForm form,
                                              const systemc::EarlierRun* earlier) {
  if (form == systemc::EvaluatorForm::computed) return std::nullopt;
  const std::span<const array::Place> pixels = earlier == nullptr ? std::span<const array::Place>() : earlier->pixels;
  const array::TreeForm trees{machine.evaluator_degree, machine.evaluator_bits, machine.register_levels};
  return array::SteppedEvaluator(whole_array(machine), trees, pixels);
}

array::PixelArray pixels_of(const machines::Machine& machine, const systemc::EarlierRun* earlier) {
  if (earlier == nullptr) return {machine.array, machine.alu_bits};
  return {earlier->pixels, machine.array.memory_bits, machine.alu_bits};
}

}  // namespace

PixelPipeline::PixelPipeline(sc_core::sc_module_name name, const machines::Machine& machine,
                             systemc::EvaluatorForm form, const systemc::EarlierRun* earlier)
    : sc_core::sc_module(name),
      period_(systemc::period_of(machine)),
      latency_(machines::evaluator_latency(machine)),
      datapath_(whole_array(machine), machine.register_levels, adders(machine, form, earlier),
                pixels_of(machine, earlier)),
      row_(pixels().shape().row_words()) {
  if (earlier != nullptr) earlier_picture_.emplace(whole_array(machine), earlier->picture);
  SC_HAS_PROCESS(PixelPipeline);
  SC_METHOD(wake);
  dont_initialize();
  sensitive << woken_;
}

/// The word is at the pixels at once if the trees have no levels (latency 0).
void PixelPipeline::put(std::uint64_t edge, const ControlWord& word, const array::RootBits& bits) {
  puts_.push_back({edge, word, bits});
  const bool requested_or = requests_or_;
  requests_or_ = word.step.function == array::AluFunction::answer;
  if (requests_or_ || requested_or) wake_at(edge + latency_);
  if (word.last) wake_at(edge + latency_ + 1);
}

void PixelPipeline::wake_at(std::uint64_t edge) {
  if (!due_.empty() && due_.front() >= edge) return;
  due_.insert(due_.begin(), edge);
  if (due_.size() == 1) schedule();
}

void PixelPipeline::schedule() {
  if (due_.empty()) return;
  const std::uint64_t at = systemc::edges(period_);
  woken_.notify(sc_core::sc_time::from_value((due_.back() - at) * period_.value()));
}

void PixelPipeline::wake() {
  due_.pop_back();
  const Datapath& datapath = now();
  question.write(datapath.at_pixels().step.function == array::AluFunction::answer);
  retired.write(datapath.retired());
  schedule();
}

const Datapath& PixelPipeline::now() const {
  const std::uint64_t edge = systemc::edges(period_);
  take_puts();
  while (edge_ < edge) {
    if (datapath_.is_active()) {
      datapath_.clock();
      ++edge_;
    } else {
      datapath_.rest();
      edge_ = next_put_ < puts_.size() ? std::min(edge, puts_[next_put_].edge) : edge;
    }
    take_puts();
  }
  return datapath_;
}

/// Applies the values put on the wires up to this edge.
void PixelPipeline::take_puts() const {
  for (; next_put_ < puts_.size() && puts_[next_put_].edge <= edge_; ++next_put_)
    datapath_.put(puts_[next_put_].word, puts_[next_put_].bits);
  if (next_put_ < puts_.size()) return;
  puts_.clear();
  next_put_ = 0;
}

std::span<const std::uint64_t> PixelPipeline::memory_row(std::uint32_t address, std::uint32_t row) const {
  if (earlier_picture_) return earlier_picture_->row(address, row);
  pixels().read_row(address, row, row_);
  return row_;
}

std::optional<RefreshStep> PixelPipeline::refreshed() const {
  const ControlWord& word = now().last_executed();
  return word.refreshes ? std::optional(word.refresh) : std::nullopt;
}

void PixelPipeline::resume(const array::PixelArray& pixels, const array::StreamBit& tree) {
  datapath_.resume(pixels, tree);
}

void PixelPipeline::show(isa::Field field) {
  if (earlier_picture_) earlier_picture_->show(field);
}

}  // namespace csgsim::pixel_planes
