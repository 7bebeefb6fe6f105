#include "hw/scan_line/refresh_collector.h"

#include <algorithm>
#include <numeric>

namespace csgsim::scan_line {

RefreshCollector::RefreshCollector(sc_core::sc_module_name name, std::uint32_t chains)
    : systemc::ClockedModule(name), refresh("refresh", chains), entering("entering", chains), line_of_chain_(chains) {}

void RefreshCollector::begin(const PictureLines& frame) {
  frame_ = frame;
  active_ = true;
  periods_.begin();
  drain_clocks_ = 0;
  lines_.assign(frame.lines.size(), {});
  for (std::vector<std::uint32_t>& line : lines_) line.reserve(frame.pixels());
  std::iota(line_of_chain_.begin(), line_of_chain_.end(), std::size_t{0});
  chains_.assign(refresh.size(), {});
  last_pixel_ = 0;
  missing_lines_ = frame.lines.size();
}

void RefreshCollector::on_clock() {
  if (!active_) return;
  periods_.edge();
  if (periods_.count() == 0) return;
  if (!any_enters()) ++drain_clocks_;
  for (std::size_t chain = 0; chain < refresh.size(); ++chain) look_at(chain);
  if (missing_lines_ > 0) return;
  active_ = false;
  frames.write(++frames_done_);
}

void RefreshCollector::look_at(std::size_t chain) {
  const RefreshPixel& pixel = refresh[chain].read();
  const bool waits = line_of_chain_[chain] < lines_.size();
  chains_[chain].add(pixel.valid ? LineActivity::showing : waits ? LineActivity::waiting_for_line : LineActivity::done);
  if (pixel.valid) collect(chain, pixel.colour);
}

void RefreshCollector::collect(std::size_t chain, std::uint32_t colour) {
  std::size_t& number = line_of_chain_[chain];
  std::vector<std::uint32_t>& line = lines_[number];
  line.push_back(colour);
  if (line.size() < frame_.pixels()) return;
  number += line_of_chain_.size();
  --missing_lines_;
  if (periods_.count() > last_pixel_) last_chain_ = chain;
  last_pixel_ = periods_.count();
}

bool RefreshCollector::any_enters() const {
  return std::any_of(entering.begin(), entering.end(), [](const auto& one) { return one.read(); });
}

}  // namespace csgsim::scan_line
