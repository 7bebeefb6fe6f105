#include "hw/bit_serial_memory/gate_mapper.h"

#include <fmt/format.h>

#include <algorithm>
#include <queue>
#include <utility>
#include <vector>

#include "hw/base/error.h"

namespace csgsim::bit_serial_memory {

namespace {

/// Truth table over x, y and z: bit i is the value for x y z = i, with x as the highest bit.
using Table = std::uint16_t;
constexpr Table unknown = 256;
constexpr std::array<Table, 3> variables{0xF0, 0xCC, 0xAA};

/// Content of the latch at each place. Only the first place of a latch is used.
using Contents = std::array<Table, max_places>;

Contents initial(Gate gate, const Aliases& aliases) {
  Contents contents;
  contents.fill(unknown);
  for (std::size_t i = 0; i < operand_count(gate); ++i)
    if (aliases[i] == i) contents[i] = variables[i];
  return contents;
}

Table table_of(Gate gate, const Aliases& aliases) {
  const Table x = variables[aliases[0] % 3];
  const Table y = variables[aliases[1] % 3];
  const Table z = variables[aliases[2] % 3];
  constexpr Table all = 0xFF;
  switch (gate) {
    case Gate::zero: return 0;
    case Gate::one: return all;
    case Gate::move: return x;
    case Gate::invert: return x ^ all;
    case Gate::conjunction: return x & y;
    case Gate::disjunction: return x | y;
    case Gate::unequal: return x ^ y;
    case Gate::equal: return x ^ y ^ all;
    case Gate::choose: return static_cast<Table>((x & y) | (~x & z));
  }
  return 0;
}

/// The place with the latch of `place`.
Place canonical(Place place, const Aliases& aliases) { return place < aliases.size() ? aliases[place] : place; }

/// Value of the command, or nothing if an input is unknown.
std::optional<Table> apply(const GateCommand& command, const std::array<Place, 3>& inputs, const Contents& contents) {
  for (std::size_t i = 0; i < command.inputs; ++i)
    if (contents[inputs[i]] == unknown) return std::nullopt;
  Table result = 0;
  for (unsigned row = 0; row < 8; ++row) {
    unsigned index = 0;
    for (std::size_t i = 0; i < command.inputs; ++i) index = 2 * index + (contents[inputs[i]] >> row & 1U);
    result = static_cast<Table>(result | (command.table >> index & 1U) << row);
  }
  return result;
}

bool is_goal(const Contents& contents, Gate gate, const Aliases& aliases) {
  return contents[aliases[target_place]] == table_of(gate, aliases);
}

/// Clocks and energy.
using Cost = std::pair<std::uint64_t, std::uint64_t>;

/// Dijkstra's algorithm over contents of the latches. Only the target and the temporaries are written.
class Search {
 public:
  Search(const CommandSet& set, Gate gate, const Aliases& aliases) : set_(set), gate_(gate), aliases_(aliases) {
    writable_.push_back(aliases[target_place]);
    for (std::uint32_t i = 0; i < set.temporaries; ++i) writable_.push_back(static_cast<Place>(first_temporary + i));
  }

  std::optional<GateSequence> run() {
    add({}, initial(gate_, aliases_), no_parent, {});
    while (!open_.empty() && nodes_.size() < max_nodes) {
      const auto [cost, number] = open_.top();
      open_.pop();
      const Contents contents = nodes_[number].contents;
      if (cost > best_.at(contents)) continue;
      if (is_goal(contents, gate_, aliases_)) return path(number);
      for (std::size_t command = 0; command < set_.commands.size(); ++command) expand(cost, number, contents, command);
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t max_nodes = 200'000;  ///< limits the time of a search to seconds
  static constexpr std::size_t no_parent = ~std::size_t{0};

  struct Node {
    Contents contents;
    std::size_t parent = no_parent;
    GateStep step;
  };

  void expand(const Cost& cost, std::size_t parent, const Contents& contents, std::size_t number) {
    const GateCommand& command = set_.commands[number];
    std::array<bool, 256> seen{};
    std::array<Place, 3> inputs{};
    const std::size_t combinations = command.inputs == 0   ? 1
                                     : command.inputs == 1 ? max_places
                                     : command.inputs == 2 ? max_places * max_places
                                                           : max_places * max_places * max_places;
    for (std::size_t combination = 0; combination < combinations; ++combination) {
      std::size_t rest = combination;
      for (std::size_t i = 0; i < command.inputs; ++i) {
        inputs[i] = static_cast<Place>(rest % max_places);
        rest /= max_places;
      }
      const std::optional<Table> value = apply(command, inputs, contents);
      if (!value || seen[*value]) continue;
      seen[*value] = true;
      for (const Place target : writable_) {
        if (contents[target] == *value) continue;
        Contents next = contents;
        next[target] = *value;
        add({cost.first + command.clocks, cost.second + command.energy_fj}, next, parent, {number, target, inputs});
      }
    }
  }

  void add(const Cost& cost, const Contents& contents, std::size_t parent, const GateStep& step) {
    const auto [found, is_new] = best_.try_emplace(contents, cost);
    if (!is_new && found->second <= cost) return;
    found->second = cost;
    open_.push({cost, nodes_.size()});
    nodes_.push_back({contents, parent, step});
  }

  [[nodiscard]] GateSequence path(std::size_t number) const {
    GateSequence steps;
    for (; nodes_[number].parent != no_parent; number = nodes_[number].parent) steps.push_back(nodes_[number].step);
    std::ranges::reverse(steps);
    return steps;
  }

  using Open = std::pair<Cost, std::size_t>;

  const CommandSet& set_;
  Gate gate_;
  const Aliases& aliases_;
  std::vector<Place> writable_;
  std::vector<Node> nodes_;
  std::map<Contents, Cost> best_;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

/// The sequence with each place replaced by the first place of its latch.
GateSequence with_aliases(GateSequence sequence, const Aliases& aliases) {
  for (GateStep& step : sequence) {
    step.target = canonical(step.target, aliases);
    for (Place& input : step.inputs) input = canonical(input, aliases);
  }
  return sequence;
}

Aliases aliases_of(const RowCommand& command) {
  const std::array<Latch, 3> operands{command.x, command.y, command.z};
  const unsigned count = operand_count(command.gate);
  Aliases aliases = no_aliases;
  for (unsigned i = 0; i < count; ++i) {
    for (unsigned j = count; j-- > 0;) {
      if (operands.at(j) == operands.at(i) && j <= i) aliases.at(i) = static_cast<Place>(j);
    }
  }
  for (unsigned j = count; j-- > 0;) {
    if (operands.at(j) == command.target) aliases[target_place] = static_cast<Place>(j);
  }
  return aliases;
}

Latch latch_at(Place place, const RowCommand& gate) {
  switch (place) {
    case 0: return gate.x;
    case 1: return gate.y;
    case 2: return gate.z;
    case target_place: return gate.target;
    default: return static_cast<Latch>(static_cast<unsigned>(Latch::first_temporary) + place - first_temporary);
  }
}

}  // namespace

bool computes(const GateSequence& sequence, Gate gate, const Aliases& aliases, const CommandSet& set) {
  Contents contents = initial(gate, aliases);
  for (const GateStep& step : with_aliases(sequence, aliases)) {
    const bool is_operand = step.target < operand_count(gate) && step.target != aliases[target_place];
    const std::optional<Table> value = apply(set.commands.at(step.command), step.inputs, contents);
    if (is_operand || !value) return false;
    contents.at(step.target) = *value;
  }
  return is_goal(contents, gate, aliases);
}

const GateSequence& GateMapper::sequence(Gate gate, const Aliases& aliases) {
  const auto found = known_.find({gate, aliases});
  if (found != known_.end()) return found->second;
  const std::optional<GateSequence>& given = set_.given.at(static_cast<std::size_t>(gate));
  std::optional<GateSequence> sequence;
  if (given && computes(*given, gate, aliases, set_))
    sequence = with_aliases(*given, aliases);
  else
    sequence = search(gate, aliases);
  if (!sequence) {
    throw InputError(
        fmt::format("{}: no sequence of these commands was found for {}; add commands or temporaries, or "
                    "give a sequence in [sequence]",
                    set_.place, name_of(gate)));
  }
  return known_.emplace(std::tuple{gate, aliases}, *sequence).first->second;
}

std::optional<GateSequence> GateMapper::search(Gate gate, const Aliases& aliases) const {
  return Search(set_, gate, aliases).run();
}

RowCommands GateMapper::expand(const RowCommands& commands) {
  RowCommands expanded;
  for (const RowCommand& command : commands) {
    if (command.op != RowOp::logic) {
      expanded.push_back(command);
      continue;
    }
    for (const GateStep& step : sequence(command.gate, aliases_of(command))) {
      const std::array<Place, 3>& inputs = step.inputs;
      expanded.push_back({.op = RowOp::logic,
                          .target = latch_at(step.target, command),
                          .x = latch_at(inputs[0], command),
                          .y = latch_at(inputs[1], command),
                          .z = latch_at(inputs[2], command),
                          .own = &set_.commands[step.command]});
    }
  }
  return expanded;
}

}  // namespace csgsim::bit_serial_memory
