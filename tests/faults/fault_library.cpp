/// Preloaded into csgsim (LD_PRELOAD): counts the system calls that make files, and fails those selected by a test.
///
/// CSGSIM_FAULT=KIND:N:ERROR[,...] fails the N-th call of the kind, KIND:N+:ERROR that call and all later ones. ERROR
/// is the name of an errno, or for writes HALF (half of the bytes are written, without an error) or SHORT (half are
/// written, and the next write fails with ENOSPC). CSGSIM_FAULT_REPORT names a file that receives a line `failed KIND N
/// after R renames` for each failed call, and at the end `calls KIND COUNT` for each kind.
///
/// The library counts files in folders that are written through the C library's functions. It does not count files
/// without a name (memfd_create), pipes, devices, and the optional text in a lock file. It cannot see calls inside the
/// C library, as from stdio.

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

enum class Kind : std::uint8_t { write, fsync, rename, ftruncate, close, open, mkfifo, memfd_create, mkdir };

constexpr auto kind_names = std::to_array<std::string_view>(
    {"write", "fsync", "rename", "ftruncate", "close", "open", "mkfifo", "memfd_create", "mkdir"});

struct Error {
  std::string_view name;
  int number;
};

constexpr auto errors = std::to_array<Error>({{"ENOSPC", ENOSPC},
                                              {"EIO", EIO},
                                              {"EDQUOT", EDQUOT},
                                              {"EINTR", EINTR},
                                              {"EACCES", EACCES},
                                              {"EMFILE", EMFILE},
                                              {"ENOMEM", ENOMEM},
                                              {"EROFS", EROFS}});

/// The outcome of a call.
enum class Fate : std::uint8_t { done, failed, half };

struct Fault {
  Kind kind = Kind::write;
  std::uint64_t first = 0;
  std::uint64_t last = 0;
  int error = 0;
  Fate fate = Fate::failed;
};

struct Plan {
  bool is_active = false;  ///< true in csgsim itself, false in programs that it starts
  std::array<Fault, 4> faults{};
  std::size_t count = 0;
};

std::array<std::atomic<std::uint64_t>, kind_names.size()> calls;

/// Writes to the report without the intercepted functions.
void report(const std::string& line) {
  const char* const path = std::getenv("CSGSIM_FAULT_REPORT");
  if (path == nullptr) return;
  const long file = ::syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  ::syscall(SYS_write, file, line.data(), line.size());
  ::syscall(SYS_close, file);
}

[[noreturn]] void refuse(std::string_view text) {
  report("misunderstood " + std::string(text) + "\n");
  std::_Exit(99);
}

std::string_view word(std::string_view& text, char end) {
  const std::size_t size = std::min(text.find(end), text.size());
  const std::string_view first = text.substr(0, size);
  text.remove_prefix(std::min(size + 1, text.size()));
  return first;
}

void plan_error(Plan& plan, Fault fault, std::string_view name) {
  if (name == "HALF" || name == "SHORT") {
    const bool is_short = name == "SHORT";
    fault.fate = Fate::half;
    plan.faults.at(plan.count++) = fault;
    if (is_short) plan.faults.at(plan.count++) = {fault.kind, fault.last + 1, fault.last + 1, ENOSPC, Fate::failed};
    return;
  }
  const auto* const error = std::find_if(errors.begin(), errors.end(), [&](const Error& e) { return e.name == name; });
  if (error == errors.end()) refuse(name);
  fault.error = error->number;
  plan.faults.at(plan.count++) = fault;
}

void plan_fault(Plan& plan, std::string_view text) {
  const std::string_view kind = word(text, ':');
  const std::string number(word(text, ':'));
  const auto* const name = std::find(kind_names.begin(), kind_names.end(), kind);
  if (name == kind_names.end()) refuse(kind);
  Fault fault;
  fault.kind = static_cast<Kind>(name - kind_names.begin());
  fault.first = std::strtoull(number.c_str(), nullptr, 10);
  if (fault.first == 0) refuse(number);
  fault.last = number.back() == '+' ? UINT64_MAX : fault.first;
  plan_error(plan, fault, text);
}

Plan read_plan() {
  Plan plan;
  plan.is_active = std::string_view(program_invocation_short_name) == "csgsim";
  const char* const text = std::getenv("CSGSIM_FAULT");
  if (!plan.is_active || text == nullptr) return plan;
  for (std::string_view rest = text; !rest.empty();) plan_fault(plan, word(rest, ','));
  return plan;
}

const Plan& the_plan() {
  static const Plan plan = read_plan();
  return plan;
}

/// Counts a call and returns its outcome; sets errno if it fails.
Fate fate(Kind kind) {
  const Plan& plan = the_plan();
  if (!plan.is_active) return Fate::done;
  const auto index = static_cast<std::size_t>(kind);
  const std::uint64_t number = ++calls.at(index);
  for (const Fault& fault : plan.faults) {
    if (fault.kind != kind || number < fault.first || number > fault.last) continue;
    const std::uint64_t renames = calls.at(static_cast<std::size_t>(Kind::rename)) - (kind == Kind::rename ? 1 : 0);
    report("failed " + std::string(kind_names.at(index)) + " " + std::to_string(number) + " after " +
           std::to_string(renames) + " renames\n");
    errno = fault.error;
    return fault.fate;
  }
  return Fate::done;
}

bool fails(Kind kind) { return fate(kind) == Fate::failed; }

/// Whether a descriptor is a file in a folder, other than a lock file.
bool counts(int number) {
  const int error = errno;
  struct stat status {};
  bool result = ::fstat(number, &status) == 0 && S_ISREG(status.st_mode) && status.st_nlink > 0;
  if (result) {
    std::array<char, 4096> path{};
    const std::string link = "/proc/self/fd/" + std::to_string(number);
    const ssize_t size = ::readlink(link.c_str(), path.data(), path.size());
    const std::string_view name(path.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    result = !name.ends_with("/.csgsim-lock");
  }
  errno = error;
  return result;
}

bool counts_for_writing(int number) {
  const int flags = ::fcntl(number, F_GETFL);
  return flags >= 0 && (flags & O_ACCMODE) != O_RDONLY && counts(number);
}

bool counts_for_writing(const char* path, int flags) {
  const std::string_view name(path);
  return (flags & O_ACCMODE) != O_RDONLY && !name.starts_with("/proc/") && !name.starts_with("/dev/");
}

bool counts_for_writing(const char* path, const char* mode) {
  const bool writes = std::string_view(mode).find_first_of("wa+") != std::string_view::npos;
  return counts_for_writing(path, writes ? O_WRONLY : O_RDONLY);
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

mode_t mode_of(int flags, va_list arguments) {
  return (flags & (O_CREAT | __O_TMPFILE)) != 0 ? static_cast<mode_t>(va_arg(arguments, int)) : 0;
}

template <class Call>
ssize_t write_some(int number, std::size_t size, Call call) {
  const Fate known = counts(number) ? fate(Kind::write) : Fate::done;
  return known == Fate::failed ? -1 : call(known == Fate::half ? size / 2 : size);
}

__attribute__((destructor)) void report_calls() {
  if (!the_plan().is_active) return;
  std::string lines;
  for (std::size_t i = 0; i < kind_names.size(); ++i)
    lines += "calls " + std::string(kind_names.at(i)) + " " + std::to_string(calls.at(i)) + "\n";
  report(lines);
}

}  // namespace

extern "C" {

ssize_t write(int number, const void* bytes, std::size_t size) {
  static const auto real = next<decltype(::write)>("write");
  return write_some(number, size, [&](std::size_t taken) { return real(number, bytes, taken); });
}

ssize_t pwrite(int number, const void* bytes, std::size_t size, off_t place) {
  static const auto real = next<decltype(::pwrite)>("pwrite");
  return write_some(number, size, [&](std::size_t taken) { return real(number, bytes, taken, place); });
}

ssize_t pwrite64(int number, const void* bytes, std::size_t size, off64_t place) {
  static const auto real = next<decltype(::pwrite64)>("pwrite64");
  return write_some(number, size, [&](std::size_t taken) { return real(number, bytes, taken, place); });
}

ssize_t writev(int number, const iovec* parts, int count) {
  static const auto real = next<decltype(::writev)>("writev");
  const auto all = static_cast<std::size_t>(std::max(count, 0));
  return write_some(number, all, [&](std::size_t taken) { return real(number, parts, static_cast<int>(taken)); });
}

int fsync(int number) {
  static const auto real = next<decltype(::fsync)>("fsync");
  return fails(Kind::fsync) ? -1 : real(number);
}

int fdatasync(int number) {
  static const auto real = next<decltype(::fdatasync)>("fdatasync");
  return fails(Kind::fsync) ? -1 : real(number);
}

int rename(const char* from, const char* to) noexcept {
  static const auto real = next<decltype(::rename)>("rename");
  return fails(Kind::rename) ? -1 : real(from, to);
}

int renameat(int from_folder, const char* from, int to_folder, const char* to) noexcept {
  static const auto real = next<decltype(::renameat)>("renameat");
  return fails(Kind::rename) ? -1 : real(from_folder, from, to_folder, to);
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) noexcept {
  static const auto real = next<decltype(::renameat2)>("renameat2");
  return fails(Kind::rename) ? -1 : real(from_folder, from, to_folder, to, flags);
}

int ftruncate(int number, off_t size) noexcept {
  static const auto real = next<decltype(::ftruncate)>("ftruncate");
  return counts(number) && fails(Kind::ftruncate) ? -1 : real(number, size);
}

int ftruncate64(int number, off64_t size) noexcept {
  static const auto real = next<decltype(::ftruncate64)>("ftruncate64");
  return counts(number) && fails(Kind::ftruncate) ? -1 : real(number, size);
}

/// Linux closes the file even if close reports an error.
int close(int number) {
  static const auto real = next<decltype(::close)>("close");
  const bool failed = counts_for_writing(number) && fails(Kind::close);
  const int error = errno;
  const int result = real(number);
  if (!failed) return result;
  errno = error;
  return -1;
}

int open(const char* path, int flags, ...) {
  static const auto real = next<decltype(::open)>("open");
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  return counts_for_writing(path, flags) && fails(Kind::open) ? -1 : real(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  static const auto real = next<decltype(::open64)>("open64");
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  return counts_for_writing(path, flags) && fails(Kind::open) ? -1 : real(path, flags, mode);
}

FILE* fopen(const char* path, const char* mode) {
  static const auto real = next<decltype(::fopen)>("fopen");
  return counts_for_writing(path, mode) && fails(Kind::open) ? nullptr : real(path, mode);
}

FILE* fopen64(const char* path, const char* mode) {
  static const auto real = next<decltype(::fopen64)>("fopen64");
  return counts_for_writing(path, mode) && fails(Kind::open) ? nullptr : real(path, mode);
}

int mkfifo(const char* path, mode_t mode) noexcept {
  static const auto real = next<decltype(::mkfifo)>("mkfifo");
  return fails(Kind::mkfifo) ? -1 : real(path, mode);
}

int memfd_create(const char* name, unsigned flags) noexcept {
  static const auto real = next<decltype(::memfd_create)>("memfd_create");
  return fails(Kind::memfd_create) ? -1 : real(name, flags);
}

int mkdir(const char* path, mode_t mode) noexcept {
  static const auto real = next<decltype(::mkdir)>("mkdir");
  return fails(Kind::mkdir) ? -1 : real(path, mode);
}
}
