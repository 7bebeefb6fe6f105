// Answers the questions of the page.
// Used by sim/app and sim/web.
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
#include "sim/viewer/json_request.h"
#include "sim/viewer/recorded.h"

namespace csgsim::viewer {

struct SessionOptions {
  /// Time limit for evaluating a model's text.
  std::chrono::milliseconds evaluation_time = std::chrono::seconds(10);
  /// Records waveforms of the machine (recorded.h).
  std::function<std::string(const isa::Program& program, std::span<const std::string> options)> recorder = record_wave;
};

/// Answers the page's questions about a model. A question is sent with a request, a JSON object with
/// - `knobs`: texts by option name (knobs.h); an array of strings for `set`; true for flags;
/// - `source`: the edited text of the model, instead of the text of its file;
/// - `evaluation`: a name by which the question can be cancelled;
/// and the members of the question. Failures are answered with status 422 and `error`, with `line` and `column` if they
/// concern the model.
class Session {
 public:
  /// Throws InputError if the file cannot be read.
  explicit Session(StartCommand beginning, SessionOptions options = {})
      : options_(std::move(options)), drawings_(std::move(beginning)), evaluations_(options_.evaluation_time) {}

  /// The questions, with the additional members of their requests:
  /// - `about`: the data that the page needs at its start;
  /// - `draw`: a picture, with the stats of csgsim render;
  /// - `explain`: the history of a pixel. Members: `pixel`, `x,y`, and `why_not`, a primitive as in --why-not;
  /// - `instant`: pixel memory before an instruction, with the active tree of the surface that it draws (instants.h,
  /// trees.h). Members: `number`, `primitive` or `clock`, `field` and `tinted`;
  /// - `tree`: the model's tree (trees.h);
  /// - `lanes`: activities of the units (lanes.h) from clock `begin` to `end`, or over the frame; or in a `window`, as
  /// in csgsim wave, with the signals of a `pixel` and of the tree levels `probes`;
  /// - `wave`: a value change dump of such a window;
  /// - `advice`: possible changes and the frame time that each saves;
  /// - `verdict`: the number of wrong pixels;
  /// - `two`: a comparison of two drawings (two.h). Members: `a` and `b`, requests;
  /// - `report`: the page of csgsim render --report for the latest drawing;
  /// - `progress`: progress of the question with this `evaluation`, a name chosen by the page (evaluations.h);
  /// - `cancel`: cancels that question. Its answer has `cancelled`.
  ///
  /// Thread-safe. A question waits for another only if both change the results of one drawing, evaluate the same model,
  /// or record waveforms.
  Reply answer(const Request& request, std::string_view path);

  /// Stops evaluations that exceed the time limit. Called several times per second.
  void end_overdue() { evaluations_.end_overdue(); }

  /// Stops all work, now and in later questions.
  void close() { evaluations_.close(); }

 private:
  struct Question;

  static const Question questions[];

  [[nodiscard]] Reply answer_request(const Request& request, std::string_view path);
  [[nodiscard]] Reply answer_post(const Request& http, std::string_view path);
  [[nodiscard]] Json about() const;
  [[nodiscard]] std::string report() const;
  [[nodiscard]] Json draw(const Json& request, Evaluation& evaluation);
  [[nodiscard]] Json explain(const Json& request, Evaluation& evaluation);
  [[nodiscard]] Json instant(const Json& request, Evaluation& evaluation);
  [[nodiscard]] Json tree(const Json& request, Evaluation& evaluation);
  [[nodiscard]] Json lanes(const Json& request, Evaluation& evaluation);
  [[nodiscard]] Json wave(const Json& request, Evaluation& evaluation);
  [[nodiscard]] Json advice(const Json& request, Evaluation& evaluation);
  [[nodiscard]] Json verdict(const Json& request, Evaluation& evaluation);
  [[nodiscard]] Json two(const Json& request, Evaluation& evaluation);

  [[nodiscard]] std::string record(const isa::Program& program, const std::vector<std::string>& options);
  [[nodiscard]] std::shared_ptr<const Lanes> find_lanes(const Drawing& drawing, const Json& request);

  SessionOptions options_;
  Drawings drawings_;
  Evaluations evaluations_;
  std::mutex recording_;  ///< held while recording: one run at a time
};

}  // namespace csgsim::viewer
