#pragma once

#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/shell/model_options.h"
#include "sim/viewer/http.h"

namespace csgsim::viewer {

using Json = nlohmann::ordered_json;

/// What the command line that began a session says.
struct Beginning {
  std::string model;               ///< file
  std::vector<std::string> words;  ///< all but the model and the knobs
  Json knobs;                      ///< those that are given, as texts by their names; texts of `set` in an array
};

/// A model, drawn as the page wishes. A wish is an object with
/// - `knobs`: texts by the names of options (knobs.h); of `set` an array of texts; of flags true;
/// - `source`: the model's text in place of its file's, if it was edited;
/// - `pixel` and `why_not`, of `explain` alone: `x,y`, and a primitive as --why-not names it;
/// - `number` or `primitive`, `field` and `tinted`, of `instant` alone (instants.h);
/// - `a` and `b`, of `two` alone: wishes.
/// What cannot be drawn is answered with the status 422 and `error`, and `line` and `column` if they are the model's.
class Session {
 public:
  /// Throws InputError where the file cannot be read.
  explicit Session(Beginning beginning);
  ~Session();

  /// `about`: what the page has to know first. `draw`: a picture, with the stats of csgsim render. `explain`: the story
  /// of a pixel. `instant`: pixel memory before an instruction. `two`: two
  /// drawings compared (two.h). `report`: the page of csgsim render --report, of what
  /// was drawn last.
  Reply answer(const Request& request, std::string_view path);

 private:
  struct Drawing;

  [[nodiscard]] Json about() const;
  [[nodiscard]] Json draw(const Json& wish);
  [[nodiscard]] Json explain(const Json& wish);
  [[nodiscard]] Json instant(const Json& wish);
  [[nodiscard]] Json two(const Json& wish);
  [[nodiscard]] std::string report() const;
  [[nodiscard]] std::vector<std::string> words_of(const Json& wish) const;
  Drawing& compiled(const Json& wish);
  Drawing& drawn(const Json& wish);

  Beginning beginning_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Drawing>> kept_;  ///< the last ones, the latest first
};

}  // namespace csgsim::viewer
