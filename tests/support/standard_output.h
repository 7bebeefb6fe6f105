#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace csgsim::testing {

/// What is written to standard output as long as it lives.
class StandardOutput {
 public:
  StandardOutput() {
    std::fflush(stdout);
    kept_ = ::dup(STDOUT_FILENO);
    const int file = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    ::dup2(file, STDOUT_FILENO);
    ::close(file);
  }
  ~StandardOutput() {
    std::fflush(stdout);
    ::dup2(kept_, STDOUT_FILENO);
    ::close(kept_);
    ::unlink(path_.c_str());
  }
  StandardOutput(const StandardOutput&) = delete;
  StandardOutput& operator=(const StandardOutput&) = delete;

  [[nodiscard]] std::string text() const {
    std::fflush(stdout);
    std::ifstream file(path_);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  std::string path_ = std::filesystem::temp_directory_path() / ("csgsim-printed-" + std::to_string(::getpid()));
  int kept_ = -1;
};

}  // namespace csgsim::testing
