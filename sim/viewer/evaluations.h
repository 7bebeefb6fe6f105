#pragma once

#include <chrono>
#include <cstdint>
#include <list>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>

#include "hw/base/interruption.h"
#include "sim/viewer/wish.h"

namespace csgsim::viewer {

/// What the work on an answer is at.
enum class Doing : std::uint8_t {
  waiting,
  evaluating,  ///< the model's text: OpenSCAD, reading, compiling. This has a limit of time
  drawing,
};

/// Why work was ended before it was done.
enum class Ended : std::uint8_t { not_yet, cancelled, overdue, closed };

class Evaluation;

/// The answers that are being worked out, so that the page can see how far they are and take them back. Any thread may
/// call any of this.
class Evaluations {
 public:
  /// `most` is the time that an evaluation may take.
  explicit Evaluations(std::chrono::milliseconds most) : most_(most) {}

  /// Those of that name, which the page has chosen.
  void cancel(std::string_view name);

  /// All: the session is about to end.
  void close();

  /// Those that evaluate for longer than they may. Called now and then.
  void end_overdue();

  /// The state of the first of that name: `doing`, the `seconds` since that began, and `most` of them, if it has a
  /// limit. Empty if there is none.
  [[nodiscard]] Json progress(std::string_view name) const;

  [[nodiscard]] std::chrono::milliseconds most() const { return most_; }

 private:
  friend class Evaluation;
  using Clock = std::chrono::steady_clock;

  struct Entry {
    std::string name;
    std::stop_source stop{};
    Doing doing = Doing::waiting;
    Clock::time_point since = Clock::now();
    Ended ended = Ended::not_yet;
  };

  static void end(Entry& entry, Ended why);

  std::chrono::milliseconds most_;
  mutable std::mutex mutex_;
  std::list<Entry> entries_;
  bool is_closed_ = false;
};

/// The work on one answer, by this thread, while it lives: the work throws Interrupted when it is to end
/// (hw/base/interruption.h).
class Evaluation {
 public:
  /// `name` may be empty: it cannot be taken back then.
  Evaluation(Evaluations& all, std::string name);
  ~Evaluation();
  Evaluation(const Evaluation&) = delete;
  Evaluation& operator=(const Evaluation&) = delete;

  void begin(Doing doing);
  [[nodiscard]] Ended ended() const;

 private:
  static std::list<Evaluations::Entry>::iterator entered(Evaluations& all, std::string name);

  Evaluations& all_;
  std::list<Evaluations::Entry>::iterator entry_;
  Interruptible interruptible_;
};

}  // namespace csgsim::viewer
