#include "hw/multi_processor/room_line.h"

#include <algorithm>

namespace csgsim::multi_processor {

RoomLine::RoomLine(sc_core::sc_module_name name, std::uint32_t nodes) : sc_core::sc_module(name), pulls_(nodes) {}

bool RoomLine::is_pulled() const { return std::find(pulls_.begin(), pulls_.end(), true) != pulls_.end(); }

}  // namespace csgsim::multi_processor
