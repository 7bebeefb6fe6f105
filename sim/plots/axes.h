// Axes of a chart: ticks, tick labels, titles and grid lines.
// Used by the layouts of charts and bars in this folder.
#pragma once

#include <string>

#include "sim/plots/drawing.h"
#include "sim/plots/extent.h"
#include "sim/plots/plot.h"

namespace csgsim::plots {

inline constexpr double title_height = 40;
inline constexpr double side_margin = 10;
inline constexpr double right_margin = 30;

void add_title(Drawing& drawing, const std::string& title);

/// Adds ticks, tick labels and the title below `area`, which spans `extent`. Labels that would overlap are rotated if
/// they are names; those that still do not fit are omitted. Returns the y coordinate at which the axis ends.
double add_x_axis(Drawing& drawing, const Axis& axis, const Extent& extent, const Box& area);

/// Adds ticks to the left of an area and the title at the left edge of the picture, in two lines if it is too long.
void add_y_axis(Drawing& drawing, const Axis& axis, const Extent& extent, const Box& area);

/// Adds lines across the area at the ticks of both axes, and the frame of the area.
void add_grid(Drawing& drawing, const std::vector<Tick>& x_ticks, const Extent& x, const std::vector<Tick>& y_ticks,
              const Extent& y, const Box& area);

/// Ticks of a y axis that is `pixels` high: those of `axis`, or those derived from `extent` if `axis` has none.
std::vector<Tick> make_y_ticks(const Axis& axis, const Extent& extent, double pixels);

/// Ticks of an x axis: those of `axis`, or those derived from `extent` if `axis` has none.
std::vector<Tick> make_x_ticks(const Axis& axis, const Extent& extent);

/// Width in pixels that a y axis with these ticks takes to the left of an area that is `pixels` high.
double y_axis_width(const Axis& axis, const std::vector<Tick>& ticks, double pixels);

}  // namespace csgsim::plots
