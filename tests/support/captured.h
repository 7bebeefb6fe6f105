#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace csgsim::testing {

/// Redirects standard output or standard error (STDOUT_FILENO or STDERR_FILENO) to a file during its lifetime.
class Captured {
 public:
  explicit Captured(int descriptor) : descriptor_(descriptor) {
    std::fflush(stdout);
    kept_ = ::dup(descriptor_);
    const int file = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (file < 0) throw std::runtime_error(path_ + " cannot be written");
    ::dup2(file, descriptor_);
    ::close(file);
  }
  ~Captured() {
    std::fflush(stdout);
    ::dup2(kept_, descriptor_);
    ::close(kept_);
    ::unlink(path_.c_str());
  }
  Captured(const Captured&) = delete;
  Captured& operator=(const Captured&) = delete;

  [[nodiscard]] std::string text() const {
    std::fflush(stdout);
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  int descriptor_;
  std::string path_ = std::filesystem::temp_directory_path() /
                      ("csgsim-captured-" + std::to_string(::getpid()) + "-" + std::to_string(descriptor_));
  int kept_ = -1;
};

}  // namespace csgsim::testing
