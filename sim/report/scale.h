#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/report/page.h"

namespace csgsim::report {

struct Tick {
  double at = 0;  ///< 0 at the beginning of the axis, 1 at its end
  std::string text;
};

/// Where values stand on an axis that shows all of them.
class Scale {
 public:
  /// About so many ticks at most. On an axis of words they are whole numbers.
  Scale(const Axis& axis, std::span<const double> values, unsigned most_ticks);

  /// 0 at the beginning of the axis, 1 at its end.
  [[nodiscard]] double at(double value) const;
  [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }

 private:
  void be_of_words(const std::vector<std::string>& names, unsigned most_ticks);
  void be_linear(std::span<const double> values, unsigned most_ticks);
  void be_logarithmic(std::span<const double> values, unsigned most_ticks);

  double low_ = 0;   ///< of the axis, or its logarithm
  double high_ = 1;  ///< the same
  bool is_logarithmic_ = false;
  double zero_ = 0;  ///< of the axis, beside a logarithmic part that begins there; 0 if there is none
  std::vector<Tick> ticks_;
};

}  // namespace csgsim::report
