// Draws a model in several frames, as a moving camera sees it.
// Used by sim/shell.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/csg/kept_results.h"
#include "host/view/camera.h"
#include "hw/isa/host_counts.h"
#include "hw/machines/machine.h"
#include "sim/observe/stats.h"
#include "sim/session/options/option_list.h"
#include "sim/session/run/render.h"

namespace csgsim::session {

inline constexpr std::uint32_t max_frames = 1000;

/// Options of drawing several frames.
struct FramesRequest {
  std::uint32_t frames = 1;
  std::optional<double> orbit;  ///< rotation of the camera during all frames, degrees
  std::string cameras;          ///< file of cameras

  void add_to(OptionList& options);

  /// Whether several frames are requested. Throws UsageError for --orbit with a single frame.
  [[nodiscard]] bool is_asked() const;
};

/// Counts of a frame, or their sums.
struct FrameCounts {
  std::uint64_t clocks = 0;  ///< see machines::FrameTiming, as the three counts below
  std::uint64_t shown_clocks = 0;
  std::uint64_t interval_clocks = 0;
  std::uint64_t host_clocks = 0;
  std::uint64_t host_model_clocks = 0;  ///< of the host for work on the model that no earlier frame has done
  std::uint64_t paced_clocks = 0;       ///< until the next frame, limited by the host too
  std::uint64_t skipped = 0;
  std::uint64_t rendered = 0;
  std::uint64_t classified = 0;
  std::uint64_t depth_tests = 0;
  observe::Cost cost;
  isa::Preparation prepared;  ///< work of the host before it writes instructions
  csg::ReuseCounts reused;    ///< work that results of earlier blocks and frames replaced

  FrameCounts& operator+=(const FrameCounts& more);
};

/// A frame that has been drawn.
struct DrawnFrame {
  view::Camera camera;
  std::string picture;  ///< its file; empty if none is written
  FrameCounts counts;
};

/// All frames that have been drawn.
struct DrawnFrames {
  machines::Machine machine;
  std::vector<DrawnFrame> frames;
  FrameCounts sums;

  /// Frames per second of the machine alone, and with its host; 0 if frames take no time.
  [[nodiscard]] double frames_per_second() const;
  [[nodiscard]] double hosted_frames_per_second() const;
};

/// Called when a frame begins, with its number and the number of frames.
using FrameProgress = std::function<void(std::size_t frame, std::size_t frames)>;

/// Draws the frames one after the other: compiles each for its camera, runs it, writes its picture and forgets both. If
/// the camera does not move, the same Program is drawn again; at the cycle level these frames are drawn as a sequence,
/// each beginning as soon as the machine can. The stats get the counts of each frame and their sums. `options` are
/// those of the command. Throws UsageError for outputs and options that are for one frame.
DrawnFrames draw_frames(const OptionList& options, const RenderRequest& request, const FramesRequest& wanted,
                        const FrameProgress& progress);

}  // namespace csgsim::session
