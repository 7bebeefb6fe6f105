#include "sim/software/convert/fragments.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <glm/geometric.hpp>
#include <iterator>
#include <mutex>
#include <span>
#include <thread>
#include <utility>

#include "host/csg/tree_paths.h"
#include "sim/software/convert/division.h"
#include "sim/software/convert/local_tree.h"
#include "sim/software/planes/sheet.h"

namespace csgsim::software::convert {

namespace {

/// The faces of bodies one after another.
class Evaluation {
 public:
  Evaluation(const Bodies& bodies, const csg::PositiveTree& tree, const Work& work)
      : bodies_(bodies),
        tree_(tree),
        paths_(tree),
        work_(work),
        sheet_(bodies.planes),
        divide_(bodies, sheet_, found_, work) {}

  void add(std::uint32_t body) {
    near_ = bodies_.meeting(bodies_.bodies[body].box);
    const auto own = std::ranges::lower_bound(near_, body);
    if (own == near_.end() || *own != body) return;
    const LocalTree tree(tree_, paths_, near_);
    for (std::uint32_t face = 0; face < bodies_.bodies[body].faces.size(); ++face) add_face(body, face, tree);
  }

  /// What was found since it was last asked.
  std::vector<Fragment> taken() { return std::exchange(found_, {}); }

 private:
  /// Whether a box has points on both sides of the plane, or may have.
  [[nodiscard]] bool meets_plane(const UnitBox& box, std::uint32_t plane) const {
    const std::array<double, 4>& near = bodies_.planes.near(plane);
    const glm::dvec3 normal(near[0], near[1], near[2]);
    const glm::dvec3 middle = (box.low + box.high) / 2.0;
    const glm::dvec3 half = (box.high - box.low) / 2.0;
    const double height = glm::dot(normal, middle) + near[3];
    return std::abs(height) <= glm::dot(glm::abs(normal), half);
  }

  [[nodiscard]] Operand operand_of(std::uint32_t number, std::uint32_t body, facet::Halfspace halfspace,
                                   const UnitBox& box) const {
    Operand operand{.body = number};
    const Body& other = bodies_.bodies[number];
    if (are_apart(other.box, box) || !meets_plane(other.box, halfspace.plane)) {
      operand.known = {true, {}};
      return operand;
    }
    int fronts = 0;
    int backs = 0;
    for (const BodyFace& face : other.faces) {
      if (face.halfspace.plane != halfspace.plane) continue;
      ++(face.halfspace.positive ? fronts : backs);
    }
    if (fronts > 0 && backs > 0) operand.known = {true, {}};  // it has no volume
    operand.is_coplanar = fronts + backs > 0;
    operand.is_behind = fronts > 0;
    operand.owns = operand.is_coplanar && number < body && !operand.known.is_known;
    return operand;
  }

  Region region_of(std::uint32_t body, const BodyFace& face) {
    std::vector<std::uint32_t> sides;
    for (const BodySide& side : bodies_.bodies[body].sides_of(face)) sides.push_back(side.plane);
    return sheet_.begin(face.halfspace.plane, sides);
  }

  /// Adds all of the face or nothing of it, if a ball about it tells which. Notes what it tells of the operands.
  bool add_whole(std::uint32_t body, const BodyFace& face, const LocalTree& tree, std::vector<Operand>& operands) {
    const glm::dvec3 middle = (face.box.low + face.box.high) / 2.0;
    std::vector<Known> known;
    std::vector<bool> may_differ;
    for (Operand& operand : operands) {
      if (!operand.known.is_known) {
        const Body& other = bodies_.bodies[operand.body];
        work_.charge(1 + other.faces.size() / 4, converting);
        const BallIs where = bodies_.ball_is(other, middle, face.radius, face.halfspace.plane);
        if (where == BallIs::outside) operand.known = {true, {}};
        if (where == BallIs::inside && !operand.is_coplanar) operand.known = {true, {true, true}};
      }
      known.push_back(operand.known);
      may_differ.push_back(operand.is_coplanar);
    }
    const LocalTree left = tree.reduced(known, may_differ);
    if (!left.value().is_known) return false;
    const Both value = left.value().value;
    if (value.behind == value.before) return true;
    const auto is_open = [](const Operand& operand) { return operand.owns && !operand.known.is_known; };
    if (std::ranges::any_of(operands, is_open)) return false;
    const Region region = region_of(body, face);
    found_.push_back(fragment_of(sheet_, region, value.behind, body, bodies_.bodies[body].sides_of(face)));
    return true;
  }

  void add_face(std::uint32_t body, std::uint32_t number, const LocalTree& tree) {
    const BodyFace& face = bodies_.bodies[body].faces[number];
    if (face.sides == 0) return;
    const facet::Halfspace halfspace = face.halfspace;
    work_.charge(near_.size(), converting);
    std::vector<Operand> operands;
    operands.reserve(near_.size());
    for (const std::uint32_t other : near_) {
      operands.push_back(operand_of(other, body, halfspace, face.box));
      if (other != body) continue;
      if (operands.back().known.is_known) return;
      operands.back().known = {true, {halfspace.positive, !halfspace.positive}};
      operands.back().owns = false;
    }
    if (add_whole(body, face, tree, operands)) return;
    const Region region = region_of(body, face);
    divide_(body, face, region, tree, std::move(operands));
  }

  const Bodies& bodies_;
  const csg::PositiveTree& tree_;
  csg::TreePaths paths_;
  const Work& work_;
  Sheet sheet_;
  std::vector<Fragment> found_;
  Division divide_;
  std::vector<std::uint32_t> near_;  ///< bodies that may meet the present one, and itself
};

/// Evaluates bodies on several threads, which take one after another.
class Sharing {
 public:
  Sharing(const Bodies& bodies, const csg::PositiveTree& tree, std::vector<std::uint32_t> numbers, const Work& work)
      : bodies_(bodies), tree_(tree), numbers_(std::move(numbers)), work_(work), found_(numbers_.size()) {}

  std::vector<Fragment> operator()(std::size_t threads) {
    {
      std::vector<std::jthread> others;
      for (std::size_t i = 1; i < threads; ++i) others.emplace_back([this] { take(); });
      take();
    }
    if (failure_) std::rethrow_exception(failure_);
    work_.charge(done_, converting);
    std::vector<Fragment> all;
    for (std::vector<Fragment>& found : found_) std::ranges::move(found, std::back_inserter(all));
    return all;
  }

 private:
  void take() {
    const Work work = work_.afresh();  // counts of several threads are added up at the end
    try {
      Evaluation evaluation(bodies_, tree_, work);
      for (std::size_t i = next_++; i < numbers_.size(); i = next_++) {
        evaluation.add(numbers_[i]);
        found_[i] = evaluation.taken();
      }
    } catch (...) {
      const std::lock_guard guard(lock_);
      failure_ = std::current_exception();
      next_ = numbers_.size();
    }
    const std::lock_guard guard(lock_);
    done_ += work.done();
  }

  const Bodies& bodies_;
  const csg::PositiveTree& tree_;
  std::vector<std::uint32_t> numbers_;
  const Work& work_;
  std::vector<std::vector<Fragment>> found_;  ///< of each body
  std::atomic<std::size_t> next_ = 0;
  std::mutex lock_;
  std::exception_ptr failure_;
  std::uint64_t done_ = 0;
};

}  // namespace

Fragment fragment_of(const Sheet& sheet, const Region& region, bool is_front, std::uint32_t body,
                     std::span<const BodySide> sides) {
  Fragment fragment{.plane = sheet.plane(), .is_front = is_front, .body = body, .corners = {}};
  const std::size_t count = region.corners.size();
  fragment.corners.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    // Reversed corners: the side after a corner is the one that was before it.
    const std::size_t at = is_front ? i : count - 1 - i;
    const std::size_t along = is_front ? at : (at + count - 1) % count;
    const std::uint32_t corner = region.corners[at];
    fragment.corners.push_back(
        {sheet.point(corner).planes, region.planes[along], corner < sides.size() ? sides[corner].vertex : no_vertex});
  }
  return fragment;
}

std::vector<Fragment> fragments(const Bodies& bodies, const csg::PositiveTree& tree, const std::vector<bool>& whole,
                                const Work& work, unsigned threads) {
  if (tree.root == model::no_index) return {};
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < bodies.bodies.size(); ++i)
    if (!whole[i]) numbers.push_back(i);
  if (numbers.empty()) return {};
  return Sharing(bodies, tree, numbers, work)(std::min<std::size_t>(threads, numbers.size()));
}

}  // namespace csgsim::software::convert
