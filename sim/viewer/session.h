#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "sim/viewer/drawings.h"
#include "sim/viewer/http.h"
#include "sim/viewer/wish.h"

namespace csgsim::viewer {

/// A model, drawn as the page wishes. A wish is an object with
/// - `knobs`: texts by the names of options (knobs.h); of `set` an array of texts; of flags true;
/// - `source`: the model's text in place of its file's, if it was edited;
/// and what belongs to the question. What cannot be drawn is answered with the status 422 and `error`, and `line` and
/// `column` if they are the model's.
class Session {
 public:
  /// Throws InputError where the file cannot be read.
  explicit Session(Beginning beginning) : drawings_(std::move(beginning)) {}

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
  /// - `report`: the page of csgsim render --report, of what was drawn last.
  ///
  /// One is answered after another, but that others are answered while a machine's wires are recorded.
  Reply answer(const Request& request, std::string_view path);

 private:
  using Lock = std::unique_lock<std::mutex>;
  struct Question;

  static const Question questions[];

  [[nodiscard]] Reply answered(const Request& request, std::string_view path, Lock& lock);
  [[nodiscard]] Json about() const;
  [[nodiscard]] std::string report() const;
  [[nodiscard]] Json draw(const Json& wish, Lock& lock);
  [[nodiscard]] Json explain(const Json& wish, Lock& lock);
  [[nodiscard]] Json instant(const Json& wish, Lock& lock);
  [[nodiscard]] Json tree(const Json& wish, Lock& lock);
  [[nodiscard]] Json lanes(const Json& wish, Lock& lock);
  [[nodiscard]] Json wave(const Json& wish, Lock& lock);
  [[nodiscard]] Json advice(const Json& wish, Lock& lock);
  [[nodiscard]] Json verdict(const Json& wish, Lock& lock);
  [[nodiscard]] Json two(const Json& wish, Lock& lock);

  [[nodiscard]] std::string recorded_of(const isa::Program& program, const std::vector<std::string>& options,
                                        Lock& lock);

  Drawings drawings_;
  std::mutex mutex_;      ///< of the drawings
  std::mutex recording_;  ///< held while wires are recorded, one run at a time; taken without mutex_
};

}  // namespace csgsim::viewer
