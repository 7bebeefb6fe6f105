#include "sim/session/run/frame_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "sim/observe/pictures.h"
#include "sim/session/options/usage.h"

namespace csgsim::session {

namespace {

namespace fs = std::filesystem;

/// A mark for a frame's number in a file name.
struct NumberMark {
  std::size_t at = 0;
  std::size_t length = 0;
  std::size_t digits = 0;
};

/// The mark in the name; nothing if it has no `%`.
std::optional<NumberMark> number_mark(const std::string& name) {
  const std::size_t at = name.find('%');
  if (at == name.npos) return std::nullopt;
  constexpr std::size_t most_digits = 9;
  const std::size_t end = name.find_first_not_of("0123456789", at + 1);
  std::size_t digits = 0;
  std::from_chars(name.data() + at + 1, name.data() + std::min(end, name.size()), digits);
  if (end == name.npos || name[end] != 'd' || digits > most_digits || name.find('%', end) != name.npos) {
    throw UsageError("--output", fmt::format("'{}' does not number frames; write one mark, as in out_%03d.png", name));
  }
  return NumberMark{at, end + 1 - at, digits};
}

}  // namespace

std::vector<fs::path> frame_paths(const fs::path& picture, std::uint32_t frame_count) {
  if (picture.empty()) return {};
  const std::string name = picture.filename().native();
  const std::optional<NumberMark> mark = number_mark(name);
  if (!mark && observe::is_animated(picture)) return {picture};
  std::vector<fs::path> paths;
  for (std::uint32_t i = 0; i < frame_count; ++i) {
    const std::string numbered =
        mark ? name.substr(0, mark->at) + fmt::format("{:0{}}", i, mark->digits) + name.substr(mark->at + mark->length)
             : fmt::format("{}_{:03}{}", picture.stem().native(), i, picture.extension().native());
    paths.push_back(picture.parent_path() / numbered);
  }
  return paths;
}

FramePictures::FramePictures(std::vector<fs::path> paths) : paths_(std::move(paths)) {
  if (paths_.empty()) return;
  if (paths_.size() == 1 && observe::is_animated(paths_.front())) {
    animation_.emplace(paths_.front(), animated_frames_per_second);
  } else {
    picture_.emplace(paths_.front());
  }
}

void FramePictures::write(const observe::Frame& frame, const isa::Program& program) {
  if (animation_) return animation_->add(frame, program);
  if (next_ == paths_.size()) return;
  if (next_ > 0) picture_.emplace(paths_[next_]);
  observe::write_picture(*picture_, frame, program);
  picture_->commit();
  picture_.reset();
  ++next_;
}

void FramePictures::finish() {
  if (animation_) animation_->commit();
}

std::string FramePictures::file_of(std::size_t frame) const {
  if (paths_.empty()) return {};
  return (animation_ ? paths_.front() : paths_.at(frame)).native();
}

}  // namespace csgsim::session
