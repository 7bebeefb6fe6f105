#include "hw/systemc/wave_recorder.h"

#include <utility>

#include "hw/systemc/kernel.h"

namespace csgsim::systemc {

WaveRecorder::WaveRecorder(sc_core::sc_module_name name, const sc_core::sc_time& period)
    : sc_core::sc_module(name), period_(period) {
  SC_HAS_PROCESS(WaveRecorder);
  SC_METHOD(proceed);
  dont_initialize();
  sensitive << next_;
}

void WaveRecorder::arm(std::unique_ptr<wave::Writer> writer, std::vector<wave::Window> windows,
                       std::uint64_t first_clock, bool stops_after_last_window) {
  writer_ = std::move(writer);
  windows_ = std::move(windows);
  window_ = 0;
  stops_ = stops_after_last_window;
  reached_ = false;
  writing_ = {};
  guard_.begin();
  if (windows_.empty()) return;
  clock_ = windows_.front().begin;
  next_.notify(sc_core::sc_time::from_value((clock_ - first_clock + 1) * period_.value() + period_.value() / 2));
}

bool WaveRecorder::finish() {
  guard_.rethrow();
  if (reached_) writer_->finish();
  writer_.reset();
  windows_.clear();
  next_.cancel();
  return reached_;
}

void WaveRecorder::proceed() {
  if (window_ == windows_.size()) return;
  reached_ = true;
  const auto begin = std::chrono::steady_clock::now();
  bool is_written = false;
  guard_.run([&] {
    writer_->sample(clock_);
    is_written = true;
  });
  writing_ += std::chrono::steady_clock::now() - begin;
  if (!is_written) {
    window_ = windows_.size();
    if (stops_) stop();
    return;
  }
  const std::uint64_t sampled = clock_++;
  if (clock_ == windows_[window_].end) {
    if (++window_ == windows_.size()) {
      if (stops_) stop();
      return;
    }
    clock_ = windows_[window_].begin;
  }
  next_.notify(sc_core::sc_time::from_value((clock_ - sampled) * period_.value()));
}

}  // namespace csgsim::systemc
