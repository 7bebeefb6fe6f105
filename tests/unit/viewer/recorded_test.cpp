#include "sim/viewer/recorded.h"

#include <unistd.h>

#include <chrono>

#include "hw/isa/binary.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace std::chrono_literals;

namespace {

/// A shell script in place of csgsim; the destructor deletes it.
struct Script {
  fs::path path = fs::temp_directory_path() / ("csgsim-wave-" + std::to_string(::getpid()));

  explicit Script(const std::string& text) {
    std::ofstream(path) << "#!/bin/sh\n" << text;
    fs::permissions(path, fs::perms::owner_all);
  }
  ~Script() { fs::remove(path); }
  Script(const Script&) = delete;
  Script& operator=(const Script&) = delete;
};

std::string recorded_with(const std::string& script, const system::ChildLimits& limits = viewer::wave_limits) {
  const Script csgsim(script);
  const std::vector<std::string> options{"--pixel=1,2", "--lanes"};
  return viewer::record_wave_with(csgsim.path, {}, options, limits);
}

std::string recording_error(const std::string& script, const system::ChildLimits& limits = viewer::wave_limits) {
  return testing::error_of([&] { static_cast<void>(recorded_with(script, limits)); });
}

}  // namespace

TEST_CASE("csgsim wave receives the options between its own and the Program on stdin") {
  CHECK(recorded_with("echo \"$*\"") == "wave /dev/stdin --pixel=1,2 --lanes --output -\n");
  const std::vector<std::byte> bytes = isa::encode({});
  CHECK(recorded_with("cat") == std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

TEST_CASE("a failed recording is reported with its reason and a fix") {
  CHECK(recording_error("echo 'csgsim: no such pixel' >&2; exit 1").find("no such pixel") != std::string::npos);
  CHECK(recording_error("echo 'csgsim: no such pixel' >&2; exit 1").find("use a smaller picture") == std::string::npos);
  system::ChildLimits small = viewer::wave_limits;
  small.output = 10;
  CHECK(recorded_with("printf 0123456789", small) == "0123456789");
  const std::string error = recording_error("printf 0123456789a", small);
  CHECK(error.starts_with("csgsim wave: "));
  CHECK(error.ends_with("; use a smaller picture, or record it with csgsim wave and a --window"));
  CHECK(testing::error_of([] { static_cast<void>(viewer::record_wave_with("/nosuch/csgsim", {}, {})); }) ==
        "cannot run csgsim wave: the csgsim executable has been moved or deleted; restart csgsim view");
}

TEST_CASE("a recording may take three minutes and print 512 MB and 64 KB of errors") {
  CHECK(viewer::wave_limits.time == 180s);
  CHECK(viewer::wave_limits.output == 536'870'912);
  CHECK(viewer::wave_limits.errors == 65'536);
}
