#pragma once

#include <stdlib.h>

#include <nlohmann/json.hpp>

#include "tests/support/test.h"

namespace csgsim::testing::cli {

namespace fs = std::filesystem;

/// A separate folder for each test, removed afterwards.
class Folder {
 public:
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "csgsim-XXXXXX").string();
    REQUIRE(::mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  [[nodiscard]] const fs::path& path() const { return path_; }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), fs::directory_iterator{}));
  }

 private:
  fs::path path_;
};

struct Outcome {
  int code = -1;
  std::string out;
  std::string err;
};

std::string content(const std::string& path);
void write(const std::string& path, const std::string& text);
/// Runs csgsim with words that need no quoting, separated by blanks.
Outcome run(const std::string& words);
/// Runs csgsim with these arguments, passed unchanged, in the folder; its output goes to files.
Outcome run_words(const std::vector<std::string>& words, const fs::path& working_folder = ".");
/// Runs another program in the same way; it is found through PATH.
Outcome run_program(const std::string& program, const std::vector<std::string>& words,
                    const fs::path& working_folder = ".");
/// Writes an executable of that name into the folder; it runs the shell commands.
void write_stand_in(const Folder& folder, const std::string& name, const std::string& shell_commands);
/// Runs csgsim in the folder, whose programs come first in PATH.
Outcome run_with_stand_ins(const Folder& folder, const std::vector<std::string>& words);
/// The argument `PATH=...` of env, with the folder first.
std::string path_argument(const Folder& folder);
/// Path of tests/models/NAME.csg in the source tree.
std::string model(const std::string& name);
/// The parsed content of a JSON file.
nlohmann::json json(const std::string& path);
/// Whether the text is exactly one line, including its line end.
bool is_one_line(const std::string& text);
/// Returns the outcome after a check that its exit code is 0.
Outcome require_success(Outcome outcome);
/// Checks that a run ended with this exit code and one line of error that contains the texts.
void fails(const Outcome& outcome, int exit_code, const std::vector<std::string>& error_texts);
/// Checks that a model is rejected: exit code 1, one line of error that contains the text, no file left behind.
void check_rejected(const std::string& path, const std::string& error_text);
/// The same check for a model with this text, written to a file m.csg.
void check_text_rejected(const std::string& csg, const std::string& error_text);
/// Runs csgsim with these words and checks for exit code 2 and one line of error that contains the text.
void check_misuse(const std::string& words, const std::string& error_text);

}  // namespace csgsim::testing::cli
