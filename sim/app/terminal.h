// Line editor of a terminal, on libedit.
// Used by csgsim debug.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace csgsim::app {

/// Reads lines from a terminal, with editing, history (arrow keys) and completion (tab key).
class Terminal {
 public:
  /// `words` are offered as completions.
  Terminal(std::string prompt, std::vector<std::string> words);
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// The next line without its end; empty at the end of input.
  std::optional<std::string> read_line();

 private:
  struct Editor;
  std::unique_ptr<Editor> editor_;
};

}  // namespace csgsim::app
