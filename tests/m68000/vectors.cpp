// Checks the processor against test cases of single instructions that were made by an independent emulator:
//
//     git clone https://github.com/SingleStepTests/m68000
//     build/release/m68000_vectors m68000/v1/*.bin
//
// Prints for each file how many cases agree in registers, memory, condition codes and clocks. Cases with instructions
// outside the subset, and with odd addresses, are skipped. The exit code is 1 if a case differs.

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tests/m68000/processor.h"

namespace {

using namespace csgsim::m68000;

constexpr std::size_t all_memory = std::size_t{1} << 24U;
constexpr std::uint32_t supervisor = 0x2000;
constexpr std::uint32_t prefetched = 4;  // bytes by which the files' program counter is ahead

class Reader {
 public:
  explicit Reader(std::string bytes) : bytes_(std::move(bytes)) {}

  template <class Number>
  Number next() {
    Number number{};
    if (at_ + sizeof number > bytes_.size()) throw std::runtime_error("the file ends within a number");
    std::memcpy(&number, bytes_.data() + at_, sizeof number);
    at_ += sizeof number;
    return number;
  }
  std::uint32_t word() { return next<std::uint32_t>(); }
  void skip(std::size_t bytes) { at_ += bytes; }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

struct State {
  std::array<std::uint32_t, 8> d{};
  std::array<std::uint32_t, 8> a{};
  std::uint32_t status = 0;
  std::uint32_t pc = 0;
  std::array<std::uint32_t, 2> prefetch{};
  std::vector<std::pair<std::uint32_t, std::uint16_t>> memory;
};

State read_state(Reader& reader) {
  State state;
  reader.skip(8);
  for (std::uint32_t& one : state.d) one = reader.word();
  for (std::size_t reg = 0; reg < 7; ++reg) state.a[reg] = reader.word();
  const std::uint32_t user_stack = reader.word();
  const std::uint32_t supervisor_stack = reader.word();
  state.status = reader.word();
  state.a[7] = (state.status & supervisor) != 0 ? supervisor_stack : user_stack;
  state.pc = reader.word();
  for (std::uint32_t& one : state.prefetch) one = reader.word();
  for (std::uint32_t left = reader.word(); left > 0; --left) {
    const std::uint32_t address = reader.word();
    state.memory.emplace_back(address, reader.next<std::uint16_t>());
  }
  return state;
}

struct Case {
  State before;
  State after;
  std::uint32_t clocks = 0;
};

Case read_case(Reader& reader) {
  Case one;
  reader.skip(8 + 8);
  reader.skip(reader.word());
  one.before = read_state(reader);
  one.after = read_state(reader);
  reader.skip(8);
  one.clocks = reader.word();
  for (std::uint32_t left = reader.word(); left > 0; --left) {
    const bool is_idle = reader.next<std::uint8_t>() == 0;
    reader.skip(is_idle ? 4 : 4 + 20);
  }
  return one;
}

std::uint32_t bits_of(const Conditions& on) {
  return std::uint32_t{on.carry} | std::uint32_t{on.overflow} << 1U | std::uint32_t{on.zero} << 2U |
         std::uint32_t{on.negative} << 3U | std::uint32_t{on.extend} << 4U;
}

Conditions conditions_of(std::uint32_t bits) {
  const auto bit = [&](unsigned place) { return ((bits >> place) & 1U) != 0; };
  return {bit(0), bit(1), bit(2), bit(3), bit(4)};
}

/// The part of the state that differs; "left out" for a case outside the subset.
std::string difference(const Case& one, Processor& processor) {
  processor.d = one.before.d;
  processor.a = one.before.a;
  processor.pc = one.before.pc - prefetched;
  processor.conditions = conditions_of(one.before.status);
  for (const auto& [address, value] : one.after.memory) processor.write(address, Size::word, 0);
  for (std::uint32_t word = 0; word < 2; ++word)
    processor.write(processor.pc + 2 * word, Size::word, one.before.prefetch[word]);
  for (const auto& [address, value] : one.before.memory) processor.write(address, Size::word, value);
  const std::uint64_t begun = processor.clocks();
  try {
    processor.step();
    if (processor.pc % 2 != 0) return "left out";
  } catch (const Stopped&) {
    return "left out";
  }
  if (processor.d != one.after.d || processor.a != one.after.a) return "registers";
  if (processor.pc != one.after.pc - prefetched) return "program counter";
  if (bits_of(processor.conditions) != (one.after.status & 0x1fU)) return "condition codes";
  for (const auto& [address, value] : one.after.memory)
    if (processor.read(address, Size::word) != value) return "memory";
  return processor.clocks() - begun == one.clocks ? "" : "clocks";
}

/// Prints a file's results and returns whether all cases agree.
bool check(const std::filesystem::path& path, Processor& processor) {
  std::ifstream file(path, std::ios::binary);
  Reader reader(std::string(std::istreambuf_iterator<char>(file), {}));
  reader.skip(4);
  std::map<std::string, unsigned> counts;
  std::map<std::string, std::string> firsts;
  const std::uint32_t cases = reader.word();
  for (std::uint32_t number = 0; number < cases; ++number) {
    const Case one = read_case(reader);
    const std::string what = difference(one, processor);
    if (++counts[what] == 1 && !what.empty())
      firsts[what] = fmt::format("case {}, {:04x}", number, one.before.prefetch[0]);
  }
  const std::string left_out = "left out";
  fmt::print("{:24} {:6} agree, {:6} left out", path.filename().string(), counts[""], counts[left_out]);
  bool all = true;
  for (const auto& [what, count] : counts) {
    if (what.empty() || what == left_out || count == 0) continue;
    all = false;
    fmt::print("; {} differ in {} ({})", count, what, firsts[what]);
  }
  fmt::print("\n");
  return all;
}

}  // namespace

int main(int count, char** words) {
  bool all = true;
  Processor processor(all_memory);
  for (const char* const path : std::span(words, static_cast<std::size_t>(count)).subspan(1))
    all = check(path, processor) && all;
  return all ? 0 : 1;
}
