// Compiled and drawn models of a viewer session.
// Used by session.h.
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
#include "sim/viewer/json_request.h"
#include "sim/viewer/lanes.h"
#include "sim/viewer/trees.h"

namespace csgsim::viewer {

/// The command line that started a session.
struct StartCommand {
  std::string model;               ///< path of its file
  std::vector<std::string> words;  ///< all words except the model and the knobs
  Json knobs;                      ///< given knobs as texts by name; `set` is an array of strings
};

/// Results about a drawing, computed on demand.
struct DrawingResults {
  std::mutex mutex;  ///< held while a member is created or changed
  std::optional<session::DrawnRun> drawn{};
  std::unique_ptr<Instants> instants{};
  std::unique_ptr<ActiveTrees> active_trees{};
  std::shared_ptr<const Lanes> lanes{};  ///< lanes of the whole frame
};

/// The compiled model of a request (json_request.h). Its address is stable, and it is immutable except for `found`.
struct Drawing {
  Json request;
  std::string text;  ///< text of the model as it was read
  session::ModelRequest options;
  machines::Machine machine;
  session::CompiledModel model;
  std::vector<std::string> words;  ///< words of a command line: the model and its options
  std::vector<std::string> warnings;
  double compiling = 0;  ///< seconds
  std::unique_ptr<DrawingResults> found = std::make_unique<DrawingResults>();

  /// The command line of the named command for the same model and options.
  [[nodiscard]] std::string command(const std::string& name) const;
};

/// The text that the page shows for a model's file: its content or, for a mesh, an import() of it. Throws InputError if
/// the file cannot be read or is not a regular file.
std::string model_text(const std::string& model);

/// The latest drawings. Thread-safe: different models are evaluated in parallel, and a model that several threads
/// request is evaluated once.
class Drawings {
 public:
  /// Throws InputError if the model's file cannot be read or is not a regular file.
  explicit Drawings(StartCommand beginning);

  [[nodiscard]] const StartCommand& beginning() const { return beginning_; }

  /// Compiles the request, or returns the existing drawing if none of its inputs has changed. Throws RequestError,
  /// InputError, UsageError for invalid options, and Interrupted.
  std::shared_ptr<Drawing> compile(const Json& request, Evaluation& evaluation);
  /// Compiles the request as compile() does, and draws it.
  std::shared_ptr<Drawing> draw(const Json& request, Evaluation& evaluation);

  /// The drawing requested last; null before the first.
  [[nodiscard]] std::shared_ptr<const Drawing> latest() const;

 private:
  /// A request of the page, and the command line and model text that result from it.
  struct ParsedRequest {
    Json request;
    std::vector<std::string> words;
    session::ModelRequest options;
    std::string text;  ///< text of the model
  };

  [[nodiscard]] std::vector<std::string> command_words(const Json& request) const;
  [[nodiscard]] ParsedRequest parse(const Json& request) const;
  [[nodiscard]] session::ModelFile model_of(const ParsedRequest& parsed) const;
  [[nodiscard]] std::shared_ptr<Drawing> evaluate(ParsedRequest parsed) const;
  std::shared_ptr<Drawing> find_cached(const ParsedRequest& parsed);
  void cache(const std::shared_ptr<Drawing>& next);
  std::shared_ptr<std::mutex> find_evaluation_mutex(const ParsedRequest& parsed);

  StartCommand beginning_;
  mutable std::mutex mutex_;                                ///< protects the members below; never held for long
  std::vector<std::shared_ptr<Drawing>> kept_;              ///< the latest first
  std::map<std::size_t, std::weak_ptr<std::mutex>> turns_;  ///< one per running evaluation, by a hash of the request
                                                            ///< and the text
};

}  // namespace csgsim::viewer
