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

/// The result of some work, and its warnings.
template <class Result>
struct Told {
  Result result;
  std::vector<std::string> warnings;
};

/// How often Python's signals are looked at.
constexpr std::chrono::milliseconds between_looks(50);

/// Carries out `work` in a thread of its own, and looks for Ctrl-C beside it. Python's other threads go on meanwhile.
/// Interrupted work ends where nothing is lost, and what Python's handler raised,
/// KeyboardInterrupt, is thrown.
template <class Work>
auto interruptibly(Work work) {
  using Result = decltype(work());
  std::packaged_task<Told<Result>(std::stop_token)> task([&work](const std::stop_token& stop) {
    const Interruptible looks_for(stop);
    const KeptLines kept;
    const SilentPrints silent;
    Result result = work();
    return Told<Result>{std::move(result), kept.lines()};
  });
  std::future<Told<Result>> done = task.get_future();
  std::optional<py::error_already_set> interruption;
  {
    const py::gil_scoped_release released;
    std::jthread thread(std::move(task));
    while (!interruption && done.wait_for(between_looks) != std::future_status::ready) {
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
