// Runs work so that Ctrl-C can interrupt it.
// Used by module.cpp.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "hw/base/interruption.h"
#include "hw/base/messages.h"
#include "hw/base/prints.h"

namespace csgsim::python {

namespace py = pybind11;

/// A result, with the warnings printed while it was computed.
template <class Result>
struct WithWarnings {
  Result result;
  std::vector<std::string> warnings;
};

/// Interval at which Python's signals are checked.
constexpr std::chrono::milliseconds signal_check_interval(50);

/// Runs `work` in a separate thread and checks for Ctrl-C meanwhile. Other Python threads continue. Interrupted work
/// stops without losing data, and the exception raised by Python's handler, KeyboardInterrupt, is thrown.
template <class Work>
auto run_interruptibly(Work work) {
  using Result = decltype(work());
  std::packaged_task<WithWarnings<Result>(std::stop_token)> task([&work](const std::stop_token& stop) {
    const Interruptible interruptible(stop);
    const CollectedLines kept;
    const SilentPrints silent;
    Result result = work();
    return WithWarnings<Result>{std::move(result), kept.lines()};
  });
  std::future<WithWarnings<Result>> done = task.get_future();
  std::optional<py::error_already_set> interruption;
  {
    const py::gil_scoped_release released;
    std::jthread thread(std::move(task));
    while (!interruption && done.wait_for(signal_check_interval) != std::future_status::ready) {
      const py::gil_scoped_acquire held;
      if (PyErr_CheckSignals() == 0) continue;
      interruption.emplace();
      thread.request_stop();
    }
  }
  if (interruption) throw *std::move(interruption);
  return done.get();
}

}  // namespace csgsim::python
