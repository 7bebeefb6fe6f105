// Progress, time limit and cancellation of requests.
// Used by drawings.h and session.h.
#pragma once

#include <chrono>
#include <cstdint>
#include <list>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>

#include "hw/base/interruption.h"
#include "sim/viewer/json_request.h"

namespace csgsim::viewer {

/// Stage of the work on an answer. Only evaluating has a time limit.
enum class Stage : std::uint8_t {
  waiting,
  evaluating,  ///< OpenSCAD, reading and compiling the model's text
  drawing,
};

/// Reason why work was stopped before its end.
enum class EndReason : std::uint8_t { not_yet, cancelled, overdue, closed };

class Evaluation;

/// The answers in progress, so that the page can show their progress and cancel them. All functions are thread-safe.
class Evaluations {
 public:
  explicit Evaluations(std::chrono::milliseconds time_limit) : time_limit_(time_limit) {}

  /// Cancels the evaluations with this name, which the page has chosen.
  void cancel(std::string_view name);

  /// Cancels all evaluations: the session is about to end.
  void close();

  /// Cancels evaluations that exceed the time limit. Called periodically.
  void end_overdue();

  /// State of the first evaluation with this name: `doing`, `seconds` since this stage began, and `most` seconds if it
  /// has a limit. Empty if there is no such evaluation.
  [[nodiscard]] Json progress(std::string_view name) const;

  [[nodiscard]] std::chrono::milliseconds time_limit() const { return time_limit_; }

 private:
  friend class Evaluation;
  using Clock = std::chrono::steady_clock;

  struct Entry {
    std::string name;
    std::stop_source stop{};
    Stage stage = Stage::waiting;
    Clock::time_point since = Clock::now();
    EndReason ended = EndReason::not_yet;
  };

  static void end(Entry& entry, EndReason why);

  std::chrono::milliseconds time_limit_;
  mutable std::mutex mutex_;
  std::list<Entry> entries_;
  bool is_closed_ = false;
};

/// The work on one answer by the current thread, for the lifetime of the object. The work throws Interrupted when it
/// must stop (hw/base/interruption.h).
class Evaluation {
 public:
  /// An evaluation with an empty name cannot be cancelled.
  Evaluation(Evaluations& all, std::string name);
  ~Evaluation();
  Evaluation(const Evaluation&) = delete;
  Evaluation& operator=(const Evaluation&) = delete;

  /// Enters a stage and restarts the count of its seconds.
  void begin(Stage stage);
  [[nodiscard]] EndReason end_reason() const;

 private:
  static std::list<Evaluations::Entry>::iterator add_entry(Evaluations& evaluations, std::string name);

  Evaluations& all_;
  std::list<Evaluations::Entry>::iterator entry_;
  Interruptible interruptible_;
};

}  // namespace csgsim::viewer
