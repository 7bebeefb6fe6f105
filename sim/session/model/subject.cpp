#include "sim/session/model/subject.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hw/base/descriptor.h"
#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/standard_streams.h"
#include "hw/isa/program_file.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/suggestions.h"

namespace csgsim::session {

namespace {

constexpr InputKind model_or_program{"a model or a Program", std::size_t{1} << 30U, "draw a smaller picture"};
constexpr std::size_t beginning = 16384;  ///< bytes of a file that are inspected

/// The beginning of a regular file, as far as it is readable; errors are reported when the file is read in full.
std::string beginning_of(const std::filesystem::path& path) {
  if (path == standard_stream) return read_file(path, model_or_program).substr(0, beginning);
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return "";
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  std::string bytes(beginning, '\0');
  const ssize_t count = file.is_open() ? ::read(file.number(), bytes.data(), bytes.size()) : 0;
  bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  return bytes;
}

std::optional<Subject> named_subject(const std::filesystem::path& path) {
  const auto row =
      std::ranges::find_if(named_subjects, [&](const NamedSubject& one) { return has_extension(path, one.ending); });
  return row == named_subjects.end() ? std::nullopt : std::optional(row->subject);
}

}  // namespace

Subject detect_input_kind(const std::filesystem::path& path) {
  const Subject by_name = path == standard_stream ? Subject::csg : named_subject(path).value_or(Subject::csg);
  const std::string begin = beginning_of(path);
  return isa::looks_like_program(std::as_bytes(std::span(begin))) ? Subject::program : by_name;
}

bool is_model(const std::filesystem::path& path) { return !is_program(path); }

bool is_program(const std::filesystem::path& path) { return detect_input_kind(path) == Subject::program; }

bool has_model_name(const std::filesystem::path& path) {
  return named_subject(path).value_or(Subject::program) != Subject::program;
}

bool has_mesh_name(const std::filesystem::path& path) { return named_subject(path) == Subject::mesh; }

std::string model_endings() {
  std::vector<std::string> endings;
  for (const NamedSubject& one : named_subjects)
    if (one.subject != Subject::program) endings.emplace_back(one.ending);
  return "models end in " + alternatives_text(endings);
}

void refuse_model(const std::filesystem::path& path) {
  const bool may_be_model = path == standard_stream || has_model_name(path);
  if (may_be_model && is_model(path))
    throw InputError(path.native() +
                     ": that is a model; csgsim render draws it, and csgsim compile makes a Program of it");
}

}  // namespace csgsim::session
