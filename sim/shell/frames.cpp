#include "sim/shell/frames.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <string>

#include "hw/base/messages.h"
#include "hw/base/text.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/progress.h"

namespace csgsim::shell {

namespace {

/// Shows `frame 12 of 60` on one line of standard error, after the first second.
class FrameLine {
 public:
  explicit FrameLine(bool shows) : shows_(shows) {}
  FrameLine(const FrameLine&) = delete;
  FrameLine& operator=(const FrameLine&) = delete;
  ~FrameLine() {
    if (is_shown_) write_message("\r\x1b[K");
  }

  void at(std::size_t frame, std::size_t frames) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    if (!shows_ || elapsed.count() < 1.0) return;
    is_shown_ = true;
    write_message(fmt::format("\r\x1b[Kframe {} of {}", frame + 1, frames));
  }

 private:
  bool shows_;
  bool is_shown_ = false;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

std::string files_text(const DrawnFrames& drawn) {
  const std::string& first = drawn.frames.front().picture;
  const std::string& last = drawn.frames.back().picture;
  if (first.empty()) return "no picture written; add -o frames.gif or -o frame.png";
  return "written to " + printable(first) + (first == last ? "" : " to " + printable(last));
}

void print_frames(const DrawnFrames& drawn) {
  const FrameCounts& sums = drawn.sums;
  const auto seconds = [&](std::uint64_t clocks) {
    return quantity(static_cast<double>(clocks) / static_cast<double>(drawn.machine.clock_hz), "s");
  };
  fmt::print("{} in {} clocks: {} frames per second", counted(drawn.frames.size(), "frame"),
             grouped(sums.interval_clocks), rounded(drawn.frames_per_second()));
  if (sums.host_clocks > 0)
    fmt::print("; {} with the host, which needs {} for the model and {} for the frames",
               rounded(drawn.hosted_frames_per_second()), seconds(sums.host_model_clocks), seconds(sums.host_clocks));
  fmt::print("; {}\n", files_text(drawn));
}

}  // namespace

void run_frames(const OptionList& options, const RenderRequest& request, const FramesRequest& wanted) {
  const DrawnFrames drawn = [&] {
    FrameLine line(shows_progress(request.run.progress));
    return draw_frames(options, request, wanted,
                       [&](std::size_t frame, std::size_t frames) { line.at(frame, frames); });
  }();
  print_frames(drawn);
}

}  // namespace csgsim::shell
