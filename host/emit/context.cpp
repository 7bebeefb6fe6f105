#include "host/emit/context.h"

#include "hw/isa/opcodes.h"

namespace csgsim::emit {

void enable_drawing(const Context& context, Broadcast& out) {
  context.base.width > 0 ? out.plain(isa::Opcode::enable_load, context.base) : out.plain(isa::Opcode::enable_all);
}

}  // namespace csgsim::emit
