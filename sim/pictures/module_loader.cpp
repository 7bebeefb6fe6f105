#include "sim/pictures/module_loader.h"

#include <atomic>
#include <future>
#include <mutex>

#include "hw/base/address_sanitizer.h"
#include "hw/base/error.h"
#include "hw/base/module.h"

namespace csgsim::pictures {

namespace {

std::atomic<bool> has_looked{false};  ///< for the libraries behind the module

/// Opens it once a process.
class Loader {
 public:
  /// Whether there is such a file.
  bool begin() {
    std::call_once(once_, [this] {
      file_ = find_module(module_file);
      if (!file_.empty()) {
        has_looked = true;
        opened_ = std::async(std::launch::async | std::launch::deferred, open_module, file_, module_symbol).share();
      }
    });
    return !file_.empty();
  }

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] const OpenedModule& opened() const { return opened_.get(); }

 private:
  std::once_flag once_;
  std::filesystem::path file_;
  std::shared_future<OpenedModule> opened_;
};

Loader& loader() {
  static Loader only;
  return only;
}

constexpr ModuleRole role{
    .file = module_file, .symbol = module_symbol, .does = "writes this format", .instead = ", or write .png"};

}  // namespace

void begin_to_open_module(const std::filesystem::path& picture) {
  if (!loader().begin()) throw InputError(picture.native() + ": " + no_module(role));
}

const Module& opened_module(const std::filesystem::path& picture) {
  begin_to_open_module(picture);
  const OpenedModule& opened = loader().opened();
  if (opened.symbol == nullptr)
    throw InputError(picture.native() + ": " + unusable_module(role, loader().file(), opened.error));
  return *static_cast<const Module*>(opened.symbol);
}

}  // namespace csgsim::pictures

#if CSGSIM_ADDRESS_SANITIZER
/// Asked by the leak checker at the end. The libraries behind OpenImageIO, some 250, leave memory behind where not all
/// of them can be opened, and run threads that the checker now and then fails to stop: it is off where they were
/// opened.
extern "C" int __lsan_is_turned_off();  // NOLINT(bugprone-reserved-identifier)
extern "C" int __lsan_is_turned_off() { return csgsim::pictures::has_looked ? 1 : 0; }
#endif
