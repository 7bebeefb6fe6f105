// Writes frames into one animated picture.
// Used by sim/session.
#pragma once

#include <filesystem>

#include "hw/base/output_file.h"
#include "sim/observe/frame.h"
#include "sim/pictures/encode.h"

namespace csgsim::observe {

/// Whether several frames can be written into one file of that name: an animated GIF.
bool is_animated(const std::filesystem::path& path);

/// Writes frames into one animated picture, without storing them. Each function throws InputError if it cannot write.
class Animation {
 public:
  Animation(const std::filesystem::path& path, unsigned frames_per_second);
  void add(const Frame& frame, const isa::Program& program);
  void commit();

 private:
  OutputFile file_;
  pictures::Animation encoder_;
};

}  // namespace csgsim::observe
