#include "hw/isa/program_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <span>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include "hw/isa/binary.h"
#include "hw/isa/error.h"
#include "hw/isa/output_file.h"
#include "hw/isa/text.h"

namespace csgsim::isa {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view what, const std::error_code& error) {
  throw InputError(fmt::format("{}: cannot {}: {}; check the path and its permissions", path.string(), what,
                               error ? error.message() : "input/output error"));
}

std::error_code last_error() { return {errno, std::generic_category()}; }

std::string read_file(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) fail(path, "read it", std::make_error_code(std::errc::is_a_directory));
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(path, "read it", last_error());
  std::string content{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) fail(path, "read it", last_error());
  return content;
}

}  // namespace

Program load_program(const std::filesystem::path& path) {
  const std::string content = read_file(path);
  const auto bytes = std::as_bytes(std::span(content));
  return is_binary(bytes) ? decode(bytes, path.string()) : parse(content, path.string());
}

void save_program(const Program& program, const std::filesystem::path& path, ProgramForm form) {
  if (form == ProgramForm::binary) {
    const std::vector<std::byte> bytes = encode(program);
    write_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  } else {
    std::ostringstream text;
    print(text, program);
    write_file(path, text.view());
  }
}

}  // namespace csgsim::isa
