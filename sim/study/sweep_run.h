#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

#include "host/emit/options.h"
#include "host/facet/scene.h"
#include "host/model/tree.h"
#include "host/view/camera.h"
#include "host/view/projection.h"
#include "hw/machines/machine.h"
#include "sim/study/sweep.h"

namespace csgsim::study {

/// A model, ready to be looked at by any number of threads.
struct Subject {
  model::Tree tree;
  facet::Scene scene;
  std::string hash;  ///< of the bytes of the model's file
};

/// A point with all that it is made from.
struct SweepJob {
  SweepPoint point;
  std::shared_ptr<const Subject> subject;
  view::Camera camera;
  view::Sampling sampling;
  machines::Machine machine;
  emit::Options options;
  Inputs inputs;
  std::string reason{};  ///< why the model cannot be read; there is no subject then
};

/// Compiles the point, counts, and, if asked to, draws it at the functional level. The clocks are those of a run. A
/// model that does not fit is a row that says why.
SweepRow measure(const SweepJob& job, bool is_drawn);

/// Measures all jobs on that many threads; each holds one Program at a time. `finished` gets the rows one at a time, in
/// the order in which they are done. The first exception ends it and is thrown again.
void measure_all(std::span<const SweepJob> jobs, bool is_drawn, unsigned threads,
                 const std::function<void(SweepRow)>& finished);

}  // namespace csgsim::study
