#include "hw/bit_serial_memory/command_set.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/nearest.h"
#include "hw/base/text.h"
#include "hw/base/toml_text.h"
#include "hw/bit_serial_memory/gate_mapper.h"

namespace csgsim::bit_serial_memory {

namespace {

constexpr std::size_t max_commands = 64;
constexpr std::size_t max_steps = 64;
constexpr std::int64_t max_gate_clocks = 65'535;
constexpr std::int64_t max_gate_fj = 1'000'000'000;

bool is_name(std::string_view text) {
  const auto is_word = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; };
  return !text.empty() && text.size() <= 16 && text.front() >= 'A' && text.front() <= 'Z' &&
         std::ranges::all_of(text, is_word);
}

class Reader {
 public:
  Reader(const toml::table& root, std::string_view file) : root_(root), file_(file) {}

  CommandSet read() {
    check_keys(root_, {{"name", "description", "temporaries", "command", "sequence"}});
    set_.name = text(root_, "name");
    set_.description = text(root_, "description");
    set_.temporaries = static_cast<std::uint32_t>(number(root_, "temporaries", 0, max_temporaries));
    read_commands();
    if (const toml::node* const node = root_.get("sequence"); node != nullptr) read_sequences(table(*node, "sequence"));
    return std::move(set_);
  }

 private:
  [[noreturn]] void fail(const toml::source_position& place, std::string_view message) const {
    throw InputError(fmt::format("{}: {}", position_text(place, file_), message));
  }

  [[noreturn]] void fail(const toml::node& node, std::string_view message) const { fail(node.source().begin, message); }

  void check_keys(const toml::table& table, const std::vector<std::string_view>& known) const {
    for (const auto& [key, node] : table) {
      if (std::ranges::find(known, key.str()) == known.end())
        fail(key.source().begin,
             fmt::format("unknown key '{}'; the nearest known is '{}'", key.str(), nearest(key.str(), known)));
    }
  }

  const toml::table& table(const toml::node& node, std::string_view key) const {
    const toml::table* const found = node.as_table();
    if (found == nullptr) fail(node, fmt::format("'{}' is {}; make it a table", key, type_name(node)));
    return *found;
  }

  const toml::node& child(const toml::table& in, std::string_view key) const {
    const toml::node* const node = in.get(key);
    if (node == nullptr) fail(in.source().begin, fmt::format("key '{}' is missing; add it", key));
    return *node;
  }

  std::string text(const toml::table& in, std::string_view key) const {
    const toml::node& node = child(in, key);
    const toml::value<std::string>* const found = node.as_string();
    if (found == nullptr) fail(node, fmt::format("'{}' is {}; make it a string", key, type_name(node)));
    if (found->get().empty()) fail(node, fmt::format("'{}' is empty; give a value", key));
    return printable(found->get());
  }

  std::int64_t number(const toml::table& in, std::string_view key, std::int64_t least, std::int64_t most) const {
    const toml::node& node = child(in, key);
    const toml::value<std::int64_t>* const found = node.as_integer();
    if (found == nullptr || found->get() < least || found->get() > most)
      fail(node, fmt::format("'{}' is not a whole number from {} to {}", key, least, most));
    return found->get();
  }

  void read_commands() {
    const toml::node& node = child(root_, "command");
    set_.place = position_text(node.source().begin, file_);
    const toml::table& all = table(node, "command");
    if (all.empty() || all.size() > max_commands)
      fail(node, fmt::format("there are {} commands; give 1 to {}", all.size(), max_commands));
    for (const auto& [key, one] : all) {
      if (!is_name(key.str()))
        fail(key.source().begin, "a command's name is 1 to 16 capital letters, digits and _, beginning with a letter");
      read_command(std::string(key.str()), table(one, key.str()));
    }
    std::ranges::sort(set_.commands, {}, &GateCommand::name);
  }

  void read_command(std::string name, const toml::table& in) {
    check_keys(in, {{"table", "clocks", "energy", "provenance", "source"}});
    GateCommand command{.name = std::move(name)};
    const std::string bits = text(in, "table");
    const toml::node& place = child(in, "table");
    if (bits.find_first_not_of("01") != std::string::npos)
      fail(place, "'table' has other characters than 0 and 1; use only these");
    while (command.inputs < 3 && bits.size() > std::size_t{1} << command.inputs) ++command.inputs;
    if (bits.size() != std::size_t{1} << command.inputs)
      fail(place, fmt::format("'table' has {} bits; a function of 0 to 3 inputs has 1, 2, 4 or 8", bits.size()));
    for (std::size_t i = 0; i < bits.size(); ++i)
      command.table = static_cast<std::uint8_t>(command.table | (bits[i] == '1' ? 1U : 0U) << i);
    command.clocks = static_cast<std::uint32_t>(number(in, "clocks", 1, max_gate_clocks));
    command.energy_fj = static_cast<std::uint64_t>(number(in, "energy", 0, max_gate_fj));
    const std::string provenance = text(in, "provenance");
    if (provenance != "published" && provenance != "assumed")
      fail(child(in, "provenance"), "'provenance' is neither published nor assumed; write one of them");
    command.is_published = provenance == "published";
    command.source = text(in, "source");
    set_.commands.push_back(std::move(command));
  }

  void read_sequences(const toml::table& all) {
    const std::vector<std::string_view> known(gate_names.begin(), gate_names.end());
    check_keys(all, known);
    for (const auto& [key, node] : all) {
      const auto number = static_cast<std::size_t>(std::ranges::find(gate_names, key.str()) - gate_names.begin());
      set_.given.at(number) = read_sequence(node, static_cast<Gate>(number));
    }
  }

  GateSequence read_sequence(const toml::node& node, Gate gate) const {
    const toml::array* const lines = node.as_array();
    if (lines == nullptr || lines->size() > max_steps)
      fail(node, fmt::format("the sequence is not an array of up to {} strings; write one", max_steps));
    GateSequence sequence;
    for (const toml::node& line : *lines) {
      const toml::value<std::string>* const words = line.as_string();
      if (words == nullptr) fail(line, fmt::format("a command of a sequence is {}; make it a string", type_name(line)));
      sequence.push_back(read_step(line, words->get()));
    }
    if (!computes(sequence, gate, no_aliases, set_)) {
      fail(node, fmt::format("the sequence does not compute {} of its operands, uses a latch before it is set, or "
                             "changes an operand",
                             name_of(gate)));
    }
    return sequence;
  }

  /// Parses `target = NAND x y`.
  GateStep read_step(const toml::node& place, const std::string& line) const {
    std::istringstream in(line);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    if (words.size() < 3 || words[1] != "=")
      fail(place, fmt::format("'{}' is not a command; write it in the form T1 = COMMAND x y", line));
    const auto command = std::ranges::find(set_.commands, words[2], &GateCommand::name);
    if (command == set_.commands.end()) {
      std::vector<std::string> names;
      for (const GateCommand& one : set_.commands) names.push_back(one.name);
      fail(place, unknown_name_text("command", words[2], names));
    }
    if (words.size() != 3 + command->inputs)
      fail(place, fmt::format("{0} has {1} inputs, but the sequence gives it {2}; write {1}", command->name,
                              command->inputs, words.size() - 3));
    GateStep step{.command = static_cast<std::size_t>(command - set_.commands.begin())};
    step.target = read_place(place, words[0]);
    for (std::size_t i = 0; i < command->inputs; ++i) step.inputs.at(i) = read_place(place, words[3 + i]);
    return step;
  }

  Place read_place(const toml::node& where, const std::string& word) const {
    std::vector<std::string> names{"x", "y", "z", "target"};
    for (std::uint32_t i = 1; i <= set_.temporaries; ++i) names.push_back(fmt::format("T{}", i));
    const auto found = std::ranges::find(names, word);
    if (found == names.end()) fail(where, unknown_name_text("latch", word, names));
    return static_cast<Place>(found - names.begin());
  }

  const toml::table& root_;
  std::string_view file_;
  CommandSet set_;
};

}  // namespace

CommandSet read_command_set(std::string_view text, std::string_view file) {
  const toml::table root = parse_toml(text, file);
  return Reader(root, file).read();
}

}  // namespace csgsim::bit_serial_memory
