// Output of several frames: numbered pictures, or one animated picture.
// Used by sim/session.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hw/base/output_file.h"
#include "sim/observe/animation.h"
#include "sim/observe/frame.h"

namespace csgsim::session {

/// Frames per second of an animated picture.
inline constexpr unsigned animated_frames_per_second = 20;

/// The path of each frame's picture: a number replaces `%d`, `%3d` or `%03d` in the name; a name without such a mark,
/// NAME.png, becomes NAME_000.png and so on; all frames are in one .gif without a mark. Throws UsageError for other
/// marks.
std::vector<std::filesystem::path> frame_paths(const std::filesystem::path& picture, std::uint32_t frame_count);

/// Writes the pictures of frames. A numbered picture is complete when write() returns; an animated one takes its place
/// in finish(). No frame is kept.
class FramePictures {
 public:
  /// `paths` are those of frame_paths, or empty if no picture is wanted. Throws InputError for a file that cannot be
  /// written.
  explicit FramePictures(std::vector<std::filesystem::path> paths);

  /// Writes the picture of the next frame.
  void write(const observe::Frame& frame, const isa::Program& program);
  void finish();

  /// The file of a frame; empty if there is none.
  [[nodiscard]] std::string file_of(std::size_t frame) const;

 private:
  std::vector<std::filesystem::path> paths_;
  std::optional<OutputFile> picture_;  ///< the next; the first is opened early, so that bad names fail before the work
  std::optional<observe::Animation> animation_;
  std::size_t next_ = 0;
};

}  // namespace csgsim::session
