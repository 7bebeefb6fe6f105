#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "hw/machines/machine.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/model_request.h"
#include "sim/session/run/run_request.h"
#include "sim/viewer/evaluations.h"
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

/// What has been found out about a drawing, once it has been asked for.
struct FoundOut {
  std::mutex mutex;  ///< held while one of these is made or changed
  std::optional<session::Drawn> drawn{};
  std::unique_ptr<Instants> instants{};
  std::unique_ptr<ActiveTrees> active_trees{};
  std::shared_ptr<const Lanes> lanes{};  ///< of the whole frame
};

/// A wish that was compiled. It stays where it is, and is not changed.
struct Drawing {
  Json wish;
  std::string text;  ///< of the model, as it was read
  session::ModelRequest options;
  machines::Machine machine;
  session::CompiledModel model;
  std::vector<std::string> words;  ///< of a command line: the model and its options
  std::vector<std::string> warnings;
  double compiling = 0;  ///< seconds
  std::unique_ptr<FoundOut> found = std::make_unique<FoundOut>();

  /// The command line of the command of that name for the same model and options.
  [[nodiscard]] std::string command(const std::string& name) const;
};

/// The drawings that were wished for last. Several threads may ask at a time: models are evaluated side by side, but
/// one that several wish for is evaluated once.
class Drawings {
 public:
  /// Throws InputError where the model's file cannot be read, or is no regular file.
  explicit Drawings(Beginning beginning);

  [[nodiscard]] const Beginning& beginning() const { return beginning_; }

  /// The same as before if nothing that it is made of has changed. Throws WishError, InputError, UsageError for
  /// options that make no sense, and Interrupted.
  std::shared_ptr<Drawing> compiled(const Json& wish, Evaluation& evaluation);
  std::shared_ptr<Drawing> drawn(const Json& wish, Evaluation& evaluation);

  /// The one that was asked for last; null before the first.
  [[nodiscard]] std::shared_ptr<const Drawing> latest() const;

 private:
  /// What a wish is made of.
  struct Asked {
    Json wish;
    std::vector<std::string> words;
    session::ModelRequest options;
    std::string text;  ///< of the model
  };

  [[nodiscard]] std::vector<std::string> words_of(const Json& wish) const;
  [[nodiscard]] Asked asked_by(const Json& wish) const;
  [[nodiscard]] session::ModelFile model_of(const Asked& asked) const;
  [[nodiscard]] std::shared_ptr<Drawing> evaluated(Asked asked) const;
  std::shared_ptr<Drawing> kept(const Asked& asked);
  void keep(const std::shared_ptr<Drawing>& next);
  std::shared_ptr<std::mutex> turn_of(const Asked& asked);

  Beginning beginning_;
  mutable std::mutex mutex_;                                ///< of what follows, never held for long
  std::vector<std::shared_ptr<Drawing>> kept_;              ///< the latest first
  std::map<std::size_t, std::weak_ptr<std::mutex>> turns_;  ///< of those that evaluate, by a hash of what they evaluate
};

}  // namespace csgsim::viewer
