#include "host/emit/display_model.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "host/csg/convex_sets.h"
#include "host/csg/locate.h"
#include "host/emit/context.h"
#include "host/emit/facet_colour.h"
#include "host/emit/near_cap.h"
#include "hw/base/error.h"

namespace csgsim::emit {

namespace {

[[noreturn]] void refuse_face(const model::Tree& tree, std::uint32_t primitive) {
  throw InputError(model::location_text(tree, primitive) +
                   ": a face of this primitive is too large for the divider: its coefficients do not fit " +
                   std::to_string(isa::max_linear_width) +
                   " bits; move the camera back, move the picture's centre onto it, lower --z-bits or "
                   "--fraction-bits, or split the primitive");
}

/// The planes that are sent, each once, in the order of their first use.
class SentPlanes {
 public:
  explicit SentPlanes(const view::View& view) : view_(view) {}

  std::uint32_t index_of(std::uint32_t canonical) {
    const auto [found, is_new] = index_.emplace(canonical, static_cast<std::uint32_t>(planes_.size()));
    if (is_new) {
      const view::ScreenPlane& plane = view_.planes[canonical];
      planes_.push_back({plane.kind == view::PlaneKind::edge, plane.linear.a, plane.linear.b, plane.linear.c});
    }
    return found->second;
  }

  std::vector<division::Plane> take() { return std::move(planes_); }

 private:
  const view::View& view_;
  std::map<std::uint32_t, std::uint32_t> index_;
  std::vector<division::Plane> planes_;
};

division::Box pixel_box(const view::Extent& extent, std::int64_t farthest) {
  const view::PixelRect& pixels = extent.pixels;
  division::Box box;
  if (!pixels.empty()) box.pixels = {pixels.x0, pixels.y0, pixels.x1, pixels.y1};
  box.z_low = std::clamp<std::int64_t>(extent.z_low, 0, farthest + 1);
  box.z_high = std::clamp<std::int64_t>(extent.z_high, -1, farthest);
  return box;
}

std::vector<division::Halfspace> list_halfspaces(const Context& context, std::uint32_t primitive, SentPlanes& planes) {
  std::vector<division::Halfspace> sent;
  const view::Extent& extent = context.view.extents[primitive];
  if (extent.empty()) return sent;
  for (const facet::Halfspace& halfspace : context.geometry.solids[primitive].halfspaces) {
    const view::ScreenPlane& plane = context.view.planes[halfspace.plane];
    if (!plane.representable) {
      const csg::Block anywhere{extent.pixels, 0, context.farthest()};
      if (csg::locate(context.view, halfspace, anywhere) != csg::Containment::in) refuse_face(context.tree, primitive);
      continue;
    }
    const view::Side side = view::side_of(plane, halfspace);
    const bool is_seen = side == (context.complemented(primitive) ? view::Side::back : view::Side::front);
    const std::uint32_t colour = is_seen ? facet_colour(context, {primitive, halfspace, At::plane}) : 0;
    sent.push_back(
        {planes.index_of(halfspace.plane), side == view::Side::front || side == view::Side::edge_positive, colour});
  }
  return sent;
}

std::vector<division::Primitive> list_primitives(const Context& context, SentPlanes& planes) {
  std::vector<division::Primitive> sent(context.tree.primitives.size());
  for (const csg::ConvexSet& set : csg::convex_sets(context.positive, true)) {
    for (const std::uint32_t primitive : set) {
      division::Primitive& one = sent[primitive];
      one.box = pixel_box(context.view.extents[primitive], context.farthest());
      one.complemented = context.complemented(primitive);
      one.joined = primitive != set.front();
      if (!one.complemented) one.near_colour = facet_colour(context, near_facet(context, primitive));
      one.halfspaces = list_halfspaces(context, primitive, planes);
    }
  }
  return sent;
}

/// The tree in postorder, without recursion, so that deep trees do not overflow the stack.
std::vector<division::Node> list_nodes(const csg::PositiveTree& tree) {
  struct Open {
    std::uint32_t node;
    std::size_t next = 0;
  };
  std::vector<division::Node> nodes;
  std::vector<Open> path;
  if (tree.root != model::no_index) path.push_back({tree.root});
  std::uint32_t leaves = 0;
  while (!path.empty()) {
    const csg::PositiveNode& node = tree.nodes[path.back().node];
    if (path.back().next < node.children.size()) {
      const std::uint32_t child = node.children[path.back().next++];
      path.push_back({child});
      continue;
    }
    if (node.is_leaf && node.primitive != leaves++) throw std::logic_error("primitives are not in tree order");
    nodes.push_back({static_cast<std::uint32_t>(node.children.size()), node.op == csg::PositiveOperator::intersect
                                                                           ? division::Operator::intersect
                                                                           : division::Operator::unite});
    path.pop_back();
  }
  return nodes;
}

division::Fields field_positions(const Layout& layout, std::uint32_t memory_bits) {
  return {layout.depth,
          layout.candidate,
          layout.colour,
          layout.candidate_colour,
          layout.mask,
          layout.mask.end(),
          memory_bits - layout.mask.end()};
}

}  // namespace

Options divider_options(Options options) {
  options.strategy = Strategy::stack;
  options.pruning = csg::Pruning::divider();
  options.prices = {};
  options.prices_on = nullptr;
  return options;
}

division::DisplayModel make_display_model(const model::Tree& tree, const facet::Geometry& geometry,
                                          const view::View& view, const Options& options, std::uint32_t memory_bits,
                                          const csg::Counted& counted) {
  if (options.colouring == Colouring::automatic)
    throw InputError("the divider needs a fixed colouring; take --colouring rebroadcast or field");
  const view::Sampling& sampling = view.sampling;
  const Layout layout =
      plan_layout({sampling.z_bits, options.colour_bits, options.colouring == Colouring::field, {}}, memory_bits);
  const csg::PositiveTree positive = csg::make_positive_tree(tree);
  const SegmentPlan segment;
  const machines::Machine machine;
  const Look look = make_look(options.scene, tree, positive, view.camera);
  Context context{tree, geometry, view, positive, segment, layout, options, machine, look};
  context.counted = counted;
  SentPlanes planes(view);
  division::DisplayModel made{
      {sampling.width, sampling.height, sampling.z_bits, sampling.fraction_bits, options.colour_bits,
       packed_background(options.scene, options.colour_bits), field_positions(layout, memory_bits)},
      {},
      list_primitives(context, planes),
      list_nodes(positive)};
  made.planes = planes.take();
  return made;
}

}  // namespace csgsim::emit
