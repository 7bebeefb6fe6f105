#pragma once

#include <span>
#include <vector>

#include "tests/performance/program_work.h"
#include "tests/performance/rounds.h"

namespace csgsim::bench {

/// Seconds until all jobs are done if each, in this order, goes to the thread that is free first (list scheduling).
double makespan(std::span<const double> jobs, unsigned threads);

/// Seconds of all tiles on `threads` threads, which synchronize after each stretch.
double makespan_by_tiles(const Replay& replay, unsigned threads);

/// Seconds if each thread takes whole segments, and they synchronize at the end.
double makespan_by_segments(const Replay& replay, unsigned threads);

}  // namespace csgsim::bench
