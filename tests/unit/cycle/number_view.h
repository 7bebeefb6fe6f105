#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>

#include "hw/systemc/run_listener.h"

namespace csgsim::test {

/// Pixels that all hold one number, which changes as the machine proceeds; its bits are the first enable word.
class NumberView final : public systemc::PixelView {
 public:
  explicit NumberView(std::uint32_t number) : number_(number) {}

  void set(std::uint32_t number) { number_ = number; }
  [[nodiscard]] std::uint64_t copies() const { return copies_; }

  void read_field(isa::Field /*field*/, std::uint32_t /*width*/, std::uint32_t /*height*/,
                  std::span<std::uint32_t> values) const override {
    std::fill(values.begin(), values.end(), number_);
  }
  void read_enable(std::uint32_t /*width*/, std::uint32_t /*height*/, std::span<std::uint64_t> words) const override {
    std::fill(words.begin(), words.end(), 0U);
    words[0] = number_;
  }
  [[nodiscard]] std::unique_ptr<const systemc::PixelView> copy() const override {
    ++copies_;
    return std::make_unique<NumberView>(number_);
  }

 private:
  std::uint32_t number_;
  mutable std::uint64_t copies_ = 0;
};

}  // namespace csgsim::test
