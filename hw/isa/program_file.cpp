#include "hw/isa/program_file.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "hw/base/input_file.h"
#include "hw/base/output_file.h"
#include "hw/base/standard_streams.h"
#include "hw/isa/binary.h"
#include "hw/isa/text.h"

namespace csgsim::isa {

namespace {

constexpr InputKind program_file{"a .csgt file", std::size_t{1} << 30U, "draw a smaller picture, or fewer primitives"};

/// The text after its leading blank lines and comments.
std::string_view first_statement(std::string_view text) {
  while (true) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == text.npos) return "";
    text.remove_prefix(begin);
    if (text.front() != '#') return text;
    text.remove_prefix(std::min(text.find('\n'), text.size()));
  }
}

}  // namespace

bool looks_like_program(std::span<const std::byte> first_bytes) {
  if (is_binary(first_bytes)) return true;
  const std::string_view text(reinterpret_cast<const char*>(first_bytes.data()), first_bytes.size());
  return first_statement(text).starts_with('.');
}

Program load_program(const std::filesystem::path& path) {
  const std::string content = read_file(path, program_file);
  const auto bytes = std::as_bytes(std::span(content));
  const std::string name = path == standard_stream ? "standard input" : path.native();
  return is_binary(bytes) ? decode(bytes, name) : parse(content, name);
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
