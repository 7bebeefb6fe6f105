#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace csgsim::app {

/// Lines from a terminal, with editing, those before by the arrow keys, and completion by the tab key.
class Terminal {
 public:
  /// `words`: those that are completed.
  Terminal(std::string prompt, std::vector<std::string> words);
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// The next line without its end; none at the end of input.
  std::optional<std::string> line();

 private:
  struct Editor;
  std::unique_ptr<Editor> editor_;
};

}  // namespace csgsim::app
