#include "host/emit/early_out.h"

#include "hw/isa/opcodes.h"
#include "hw/machines/clocks.h"
#include "hw/machines/regions.h"

namespace csgsim::emit {

namespace {

/// Minimum number of clocks that a skip must save for each clock of its test.
constexpr std::uint64_t min_gain = 16;

}  // namespace

void emit_early_out(const Context& context, Broadcast& out, std::size_t begin, const isa::Origin& origin) {
  if (!context.options.pruning.early_out || !machines::has_global_or(context.machine)) return;
  const std::span<const isa::Instruction> guarded = out.from(begin);
  const isa::Instruction question{isa::Opcode::skip_if_none, {}, {}, guarded.size(), origin};
  if (machines::clocks(guarded, context.machine) >= min_gain * machines::clocks(question, context.machine))
    out.insert(begin, question);
}

}  // namespace csgsim::emit
