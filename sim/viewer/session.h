#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/viewer/drawings.h"
#include "sim/viewer/evaluations.h"
#include "sim/viewer/http.h"
#include "sim/viewer/recorded.h"
#include "sim/viewer/wish.h"

namespace csgsim::viewer {

struct SessionOptions {
  /// The limit on evaluating a model's text.
  std::chrono::milliseconds evaluation_time = std::chrono::seconds(10);
  /// Records the machine's wires (recorded.h).
  std::function<std::string(const isa::Program& program, std::span<const std::string> options)> recorder = recorded;
};

/// A model, drawn as the page wishes. A wish is an object with
/// - `knobs`: texts by the names of options (knobs.h); of `set` an array of texts; of flags true;
/// - `source`: the model's text in place of its file's, if it was edited;
/// - `evaluation`: a name of the question, by which it can be cancelled;
/// and what belongs to the question. What cannot be drawn is answered with the status 422 and `error`, and `line` and
/// `column` if they are the model's.
class Session {
 public:
  /// Throws InputError where the file cannot be read.
  explicit Session(Beginning beginning, SessionOptions options = {})
      : options_(std::move(options)), drawings_(std::move(beginning)), evaluations_(options_.evaluation_time) {}

  /// The questions, with the members of their wishes:
  /// - `about`: what the page has to know first;
  /// - `draw`: a picture, with the stats of csgsim render;
  /// - `explain`: the story of a pixel. `pixel`, `x,y`, and `why_not`, a primitive as --why-not names it;
  /// - `instant`: pixel memory before an instruction, with the active tree of the surface that it draws (instants.h,
  ///   trees.h). `number`, `primitive` or `clock`, `field` and `tinted`;
  /// - `tree`: the model's (trees.h);
  /// - `lanes`: what the parts are at (lanes.h) from clock `begin` to `end`, or over the frame; or in a `window` with
  ///   those of a `pixel` and of levels of trees, `probes`, each as csgsim wave has them;
  /// - `wave`: a value change dump of such a window;
  /// - `advice`: what could be turned, and what that is worth;
  /// - `verdict`: how many pixels are wrong;
  /// - `two`: two drawings compared (two.h). `a` and `b`, wishes;
  /// - `report`: the page of csgsim render --report, of what was drawn last;
  /// - `progress`: how far the question is that has this `evaluation`, a name that the page has chosen (evaluations.h);
  /// - `cancel`: ends that question. Its answer has `cancelled`.
  ///
  /// Any number of threads may ask: a question waits for another only if both are of one drawing and change what is
  /// known of it, or wish for the same model while it is evaluated, or record wires.
  Reply answer(const Request& request, std::string_view path);

  /// Ends evaluations that take longer than they may. Called several times a second.
  void end_overdue() { evaluations_.end_overdue(); }

  /// Ends all work, and what is asked from now on.
  void close() { evaluations_.close(); }

 private:
  struct Question;

  static const Question questions[];

  [[nodiscard]] Reply answered(const Request& request, std::string_view path);
  [[nodiscard]] Reply answered_post(const Request& request, std::string_view path);
  [[nodiscard]] Json about() const;
  [[nodiscard]] std::string report() const;
  [[nodiscard]] Json draw(const Json& wish, Evaluation& evaluation);
  [[nodiscard]] Json explain(const Json& wish, Evaluation& evaluation);
  [[nodiscard]] Json instant(const Json& wish, Evaluation& evaluation);
  [[nodiscard]] Json tree(const Json& wish, Evaluation& evaluation);
  [[nodiscard]] Json lanes(const Json& wish, Evaluation& evaluation);
  [[nodiscard]] Json wave(const Json& wish, Evaluation& evaluation);
  [[nodiscard]] Json advice(const Json& wish, Evaluation& evaluation);
  [[nodiscard]] Json verdict(const Json& wish, Evaluation& evaluation);
  [[nodiscard]] Json two(const Json& wish, Evaluation& evaluation);

  [[nodiscard]] std::string recorded_of(const isa::Program& program, const std::vector<std::string>& options);
  [[nodiscard]] std::shared_ptr<const Lanes> lanes_of(const Drawing& drawing, const Json& wish);

  SessionOptions options_;
  Drawings drawings_;
  Evaluations evaluations_;
  std::mutex recording_;  ///< held while wires are recorded, one run at a time
};

}  // namespace csgsim::viewer
