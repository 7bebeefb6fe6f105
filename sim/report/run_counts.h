#pragma once

#include <array>
#include <utility>

namespace csgsim::report {

/// Counts of a run that pages show: what each is, and where it stands in the stats. Not all runs have all.
inline constexpr auto run_counts = std::to_array<std::pair<const char*, const char*>>({
    {"primitives", "/model/primitives"},
    {"half-spaces", "/model/halfspaces"},
    {"clocks until it is drawn", "/clocks"},
    {"clocks until it is shown", "/shown_clocks"},
    {"clocks from one frame to the next", "/interval_clocks"},
    {"seconds until it is drawn", "/simulated_seconds"},
    {"seconds until it is shown", "/frame_seconds"},
    {"frames a second", "/frames_per_second"},
    {"instructions carried out", "/instructions/total"},
    {"instructions skipped", "/instructions/skipped"},
    {"scan-conversions, rendered", "/scan_conversions/rendered"},
    {"scan-conversions, classified", "/scan_conversions/classified"},
    {"depth tests", "/depth_tests"},
    {"pixel operations", "/pixel_operations/total"},
    {"of these, at enabled pixels", "/pixel_operations/enabled"},
    {"memory bits a pixel, used", "/memory/used_bits"},
    {"memory bits a pixel, of the machine", "/memory/memory_bits"},
    {"wrong pixels", "/accuracy/wrong"},
});

}  // namespace csgsim::report
