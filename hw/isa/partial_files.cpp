#include "hw/isa/partial_files.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <string>

namespace csgsim {

namespace {

/// A path where a signal handler can read it.
struct Slot {
  std::atomic<bool> taken = false;  ///< by an object
  std::atomic<bool> valid = false;  ///< the path is complete
  std::array<char, 4096> path{};
};

/// More than any command writes at once; files beyond have no slot.
constexpr std::size_t slot_count = 32;

std::array<Slot, slot_count>& slots() {
  static std::array<Slot, slot_count> all;
  return all;
}

std::optional<std::size_t> take_slot(const std::string& path) {
  if (path.size() >= Slot{}.path.size()) return std::nullopt;
  for (std::size_t i = 0; i < slot_count; ++i) {
    Slot& slot = slots()[i];
    if (slot.taken.exchange(true)) continue;
    slot.path[path.copy(slot.path.data(), path.size())] = '\0';
    slot.valid = true;
    return i;
  }
  return std::nullopt;
}

/// Calls only what a signal handler may call.
extern "C" void delete_partial_files(int signal) {
  for (const Slot& slot : slots()) {
    if (slot.valid) ::unlink(slot.path.data());
  }
  std::signal(signal, SIG_DFL);
  ::raise(signal);
}

}  // namespace

PartialFile::PartialFile(const std::filesystem::path& path) : slot_(take_slot(path.string())) {}

PartialFile::~PartialFile() {
  if (!slot_) return;
  slots()[*slot_].valid = false;
  slots()[*slot_].taken = false;
}

void delete_partial_files_on_signals() {
  slots();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
    if (std::signal(signal, delete_partial_files) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
}

}  // namespace csgsim
