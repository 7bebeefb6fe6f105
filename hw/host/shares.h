// Shares of several processors in the work of the host.
// Used by host.cpp and tests.
#pragma once

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/processors/operations.h"
#include "hw/processors/processor.h"

namespace csgsim::host {

/// Work of the busiest of the Kind::host_processor_count() processors of that type that share the work of
/// host::count_operations(). A chunk is the instructions from one enable_all or enable_load to the next. Processors
/// take the chunks of the frame in turn, each with its part of the segment's preparation. They also take the
/// preparation of the frame in turn, in as many equal parts as the segment with the most chunks has. The first
/// processor merges: it copies the longs of the others into the order of the chunks.
processors::Operations busiest_processor_operations(const isa::Program& program, const machines::Machine& machine,
                                                    const processors::Processor& processor);

/// Work done once for the model by the busiest of the Kind::host_processor_count() processors. The processors take
/// equal parts in turn; the number of parts is that of the chunks of the segment with the most.
processors::Operations busiest_processor_model_operations(const isa::Program& program,
                                                          const machines::Machine& machine);

}  // namespace csgsim::host
