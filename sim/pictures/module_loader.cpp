#include "sim/pictures/module_loader.h"

#include <atomic>
#include <future>
#include <mutex>

#include "hw/base/address_sanitizer.h"
#include "hw/base/error.h"
#include "hw/base/module.h"

namespace csgsim::pictures {

namespace {

std::atomic<bool> has_begun_to_open{false};

/// Opens the module once per process.
class Loader {
 public:
  /// Starts opening the module. Returns whether its file exists.
  bool begin() {
    std::call_once(once_, [this] {
      file_ = find_module(module_file);
      if (!file_.empty()) {
        has_begun_to_open = true;
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

#ifdef CSGSIM_WITHOUT_PICTURES
constexpr const char* disabling_option = "CSGSIM_PICTURES";
#else
constexpr const char* disabling_option = nullptr;
#endif

constexpr ModuleRole role{.file = module_file,
                          .symbol = module_symbol,
                          .does = "writes this format",
                          .instead = ", or write .png",
                          .disabling_option = disabling_option};

}  // namespace

void start_opening_module(const std::filesystem::path& picture_path) {
  if (!loader().begin()) throw InputError(picture_path.native() + ": " + module_missing_text(role));
}

const Module& wait_for_module(const std::filesystem::path& picture_path) {
  start_opening_module(picture_path);
  const OpenedModule& opened = loader().opened();
  if (opened.symbol == nullptr)
    throw InputError(picture_path.native() + ": " + module_unusable_text(role, loader().file(), opened.error));
  return *static_cast<const Module*>(opened.symbol);
}

}  // namespace csgsim::pictures

#if CSGSIM_ADDRESS_SANITIZER
/// Called by the leak checker at exit. The 250 or so libraries behind OpenImageIO leak memory if some of them cannot be
/// opened, and run threads that the checker sometimes fails to stop, so the check is disabled if they were opened.
extern "C" int __lsan_is_turned_off();  // NOLINT(bugprone-reserved-identifier)
extern "C" int __lsan_is_turned_off() { return csgsim::pictures::has_begun_to_open ? 1 : 0; }
#endif
