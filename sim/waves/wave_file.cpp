#include "sim/waves/wave_file.h"

#include <fmt/format.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp is POSIX

#include <array>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include "hw/base/blocked_signals.h"
#include "hw/base/error.h"
#include "sim/system/child_process.h"

namespace csgsim::waves {

namespace {

/// Limits of vcd2fst, whose input has no other limit.
constexpr system::ChildLimits limits{.time = std::chrono::hours(1),
                                     .output = std::size_t{1} << 20U,
                                     .errors = std::size_t{1} << 20U,
                                     .memory = std::size_t{8} << 30U};

/// A temporary folder, since vcd2fst writes other files beside its output.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::filesystem::path& purpose) {
    std::string name = (std::filesystem::temp_directory_path() / "csgsim-XXXXXX").native();
    if (::mkdtemp(name.data()) == nullptr)
      throw InputError(purpose.native() + ": cannot create a temporary folder; set TMPDIR to a writable folder");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

WaveFile::WaveFile(OutputFile& file, bool is_fst) : file_(file) {
  if (is_fst) dump_.emplace(file.requested());
}

void WaveFile::write(std::string_view text) {
  if (dump_) {
    dump_->append(text);
  } else {
    file_.write(text);
  }
}

void WaveFile::finish() {
  if (!dump_) return;
  dump_->rewind();
  const BlockedSignals held;  // a signal must not leave the temporary folder behind
  const TemporaryFolder folder(file_.requested());
  const std::string made = (folder.path() / "wave.fst").native();
  const std::array<std::string, 3> words{"vcd2fst", "-", made};
  const std::optional<system::ChildEnd> ended = system::run_child(words, *dump_, limits);
  if (!ended) {
    throw InputError(file_.requested().native() +
                     ": cannot run vcd2fst; install it (package gtkwave) or choose a name that ends in .vcd");
  }
  std::ifstream fst(made, std::ios::binary);
  const std::string content((std::istreambuf_iterator<char>(fst)), std::istreambuf_iterator<char>());
  if (!system::has_succeeded(*ended) || content.empty()) {
    throw InputError(fmt::format("{}: vcd2fst failed ({}); choose a name that ends in .vcd", file_.requested().native(),
                                 system::failure_text(*ended, limits)));
  }
  file_.write(content);
}

}  // namespace csgsim::waves
