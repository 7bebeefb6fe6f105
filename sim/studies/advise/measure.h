#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "host/emit/options.h"
#include "host/view/camera.h"
#include "host/view/projection.h"
#include "hw/machines/machine.h"
#include "sim/studies/advise/advice.h"
#include "sim/studies/jobs.h"

namespace csgsim::studies {

/// Memory bits a pixel that a choice may take. Those that take more are rows that say so.
inline constexpr std::uint32_t most_advice_bits = 512;

/// A model and all that its points have in common.
struct AdviceJob {
  std::shared_ptr<const Subject> subject;
  view::Camera camera;
  view::Sampling sampling;  ///< but z bits and fraction bits
  emit::Options options;    ///< but strategy, stack bits, colouring and colour bits
  /// One for each ALU width that points have; of each the picture is as large as `sampling` says.
  std::vector<machines::Machine> machines;
  Inputs inputs;
};

/// Measures the points on that many threads. Each is compiled for a machine with just as many memory bits as it takes,
/// and its clocks are those of a run; its picture is drawn, and judged, once for all points with the same z bits,
/// fraction bits and colour bits, which draw the same. `finished` gets the rows one at a time, in the order in which
/// they are done. The first exception ends it and is thrown again.
void measure_advice(const AdviceJob& job, std::span<const AdvicePoint> points, unsigned threads,
                    const std::function<void(AdviceRow)>& finished);

/// Draws the point and judges its own picture, as measure_advice need not: the two have to be equal.
AdviceRow draw_advice(const AdviceJob& job, const AdvicePoint& point);

}  // namespace csgsim::studies
