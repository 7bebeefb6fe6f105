#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hw/machines/machine.h"
#include "sim/shell/compiled_model.h"
#include "sim/shell/model_options.h"
#include "sim/shell/run_options.h"
#include "sim/viewer/instants.h"
#include "sim/viewer/lanes.h"
#include "sim/viewer/trees.h"
#include "sim/viewer/wish.h"

namespace csgsim::viewer {

/// What the command line that began a session says.
struct Beginning {
  std::string model;               ///< file
  std::vector<std::string> words;  ///< all but the model and the knobs
  Json knobs;                      ///< those that are given, as texts by their names; texts of `set` in an array
};

/// A wish that was compiled, and what has been found out about it. It stays where it is.
struct Drawing {
  Json wish;
  std::string text;  ///< of the model, as it was read
  shell::ModelOptions options;
  machines::Machine machine;
  shell::CompiledModel model;
  std::string command;  ///< that draws the same
  std::vector<std::string> warnings;
  double compiling = 0;  ///< seconds

  // Once they have been asked for.
  std::optional<shell::Drawn> drawn{};
  std::unique_ptr<Instants> instants{};
  std::unique_ptr<ActiveTrees> active_trees{};
  std::shared_ptr<const Lanes> lanes{};  ///< of the whole frame
};

/// The drawings that were wished for last.
class Drawings {
 public:
  /// Throws InputError where the model's file cannot be read.
  explicit Drawings(Beginning beginning);

  [[nodiscard]] const Beginning& beginning() const { return beginning_; }

  /// The same as before if nothing that it is made of has changed. Throws WishError, InputError, and UsageError for
  /// options that make no sense.
  std::shared_ptr<Drawing> compiled(const Json& wish);
  std::shared_ptr<Drawing> drawn(const Json& wish);

  /// The one that was asked for last; null before the first.
  [[nodiscard]] const Drawing* latest() const { return kept_.empty() ? nullptr : kept_.front().get(); }

 private:
  [[nodiscard]] std::vector<std::string> words_of(const Json& wish) const;
  [[nodiscard]] shell::ModelFile model_of(const Json& wish, const shell::ModelOptions& options,
                                          const std::string& text) const;

  Beginning beginning_;
  std::vector<std::shared_ptr<Drawing>> kept_;  ///< the latest first
};

}  // namespace csgsim::viewer
