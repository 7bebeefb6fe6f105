// Cameras as text: the value of --camera, and files of cameras.
// Used by sim/session.
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "host/view/camera.h"

namespace csgsim::session {

/// A fault in the text of a camera.
class CameraError : public std::runtime_error {
 public:
  CameraError(std::size_t at, const std::string& message) : std::runtime_error(message), at_(at) {}
  /// Number of characters of the text before the fault.
  [[nodiscard]] std::size_t at() const { return at_; }

 private:
  std::size_t at_;
};

/// Parses eye and centre, or centre, rotations and distance, separated by commas. Throws CameraError.
view::Camera parse_camera(std::string_view text);

/// Reads a file with one camera per line. `#` begins a comment; lines without a camera are ignored. Throws InputError
/// with line and column, and for a file without cameras or with more than `max_cameras`.
std::vector<view::Camera> read_cameras(const std::filesystem::path& path, std::size_t max_cameras);

}  // namespace csgsim::session
