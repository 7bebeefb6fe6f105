#include "sim/observe/animation.h"

#include <cstdint>
#include <vector>

#include "sim/observe/pictures.h"

namespace csgsim::observe {

bool is_animated(const std::filesystem::path& path) { return pictures::is_animated(path); }

Animation::Animation(const std::filesystem::path& path, unsigned frames_per_second)
    : file_(path), encoder_(path, frames_per_second) {}

void Animation::add(const Frame& frame, const isa::Program& program) {
  const std::vector<std::uint8_t> channels = rgb_bytes(frame, program);
  file_.write(encoder_.add({frame.width, frame.height, 3, {}, pictures::Bytes(channels)}));
}

void Animation::commit() {
  file_.write(encoder_.finish());
  file_.commit();
}

}  // namespace csgsim::observe
