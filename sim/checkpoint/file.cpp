#include "sim/checkpoint/file.h"

#include <string>
#include <string_view>

#include "hw/base/input_file.h"
#include "hw/base/output_file.h"

namespace csgsim::checkpoint {

namespace {

constexpr InputKind checkpoint_input{"a checkpoint that csgsim wrote", std::size_t{4} << 30U,
                                     "run the Program from its beginning", true};

}  // namespace

void save_snapshot(const std::filesystem::path& path, const Snapshot& snapshot) {
  const std::vector<std::byte> bytes = encode(snapshot);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  check_length(path.native(), text.size(), checkpoint_input);
  write_file(path, text);
}

Snapshot load_snapshot(const std::filesystem::path& path, const isa::Program& program,
                       const machines::Machine& machine) {
  const std::string text = read_regular_file(path, checkpoint_input);
  return decode(std::as_bytes(std::span(text)), path.native(), program, machine);
}

Snapshot take_snapshot(RunIdentity identity, const engine::Run& run, const observe::FrameObserver& frame,
                       const observe::StatsObserver& stats) {
  return {identity, run.save(), frame.gathered(), stats.stats()};
}

void resume(const Snapshot& snapshot, engine::Run& run, observe::FrameObserver& frame, observe::StatsObserver& stats) {
  run.restore(snapshot.run);
  frame.restore(snapshot.picture);
  stats.restore(snapshot.stats);
}

}  // namespace csgsim::checkpoint
