#include "sim/software/convert/fragments.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <glm/geometric.hpp>
#include <mutex>
#include <numeric>
#include <optional>
#include <span>
#include <thread>
#include <utility>

#include "host/csg/tree_paths.h"
#include "sim/software/convert/division.h"
#include "sim/software/convert/local_tree.h"
#include "sim/software/planes/sheet.h"

namespace csgsim::software::convert {

namespace {

/// A ball around faces of a body, in units.
struct Ball {
  glm::dvec3 middle{0};
  double radius = 0;
};

/// Computes the fragments of one body after another.
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
    const std::vector<std::uint32_t> near = bodies_.bodies_meeting(bodies_.bodies[body].box);
    if (!std::ranges::binary_search(near, body)) return;
    work_.charge(near.size(), converting);
    std::vector<Operand> operands(near.size());
    for (std::size_t i = 0; i < near.size(); ++i) {
      operands[i].body = near[i];
      if (near[i] != body) operands[i].tests = numbers_below(bodies_.bodies[near[i]].faces.size());
    }
    own_ = body;
    Numbers faces = numbers_below(bodies_.bodies[body].faces.size());
    const auto has_no_area = [&](std::uint32_t face) { return own().faces[face].sides == 0; };
    faces.erase(std::remove_if(faces.begin(), faces.end(), has_no_area), faces.end());
    if (!faces.empty()) add_group({faces.data(), faces.size()}, LocalTree(tree_, paths_, near), std::move(operands));
  }

  /// Returns and removes all fragments.
  std::vector<Fragment> release() { return std::exchange(found_, {}); }

 private:
  static Numbers numbers_below(std::size_t count) {
    Numbers numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0U);
    return numbers;
  }

  [[nodiscard]] const Body& own() const { return bodies_.bodies[own_]; }

  /// Whether a box may have points on both sides of the plane.
  [[nodiscard]] bool meets_plane(const UnitBox& box, std::uint32_t plane) const {
    const std::array<double, 4>& near = bodies_.planes.coefficients(plane);
    const glm::dvec3 normal(near[0], near[1], near[2]);
    const glm::dvec3 middle = (box.low + box.high) / 2.0;
    const glm::dvec3 half = (box.high - box.low) / 2.0;
    const double height = glm::dot(normal, middle) + near[3];
    return std::abs(height) <= glm::dot(glm::abs(normal), half);
  }

  [[nodiscard]] static glm::dvec3 middle_of(const BodyFace& face) { return (face.box.low + face.box.high) / 2.0; }

  [[nodiscard]] Ball ball_about(std::span<const std::uint32_t> faces) const {
    UnitBox box = own().faces[faces.front()].box;
    for (const std::uint32_t face : faces) {
      box.low = glm::min(box.low, own().faces[face].box.low);
      box.high = glm::max(box.high, own().faces[face].box.high);
    }
    Ball ball{(box.low + box.high) / 2.0, 0};
    for (const std::uint32_t number : faces) {
      const BodyFace& face = own().faces[number];
      ball.radius = std::max(ball.radius, glm::distance(ball.middle, middle_of(face)) + face.radius);
    }
    return ball;
  }

  /// Whether a ball is inside or outside an operand; if undecided, keeps the faces whose planes may intersect it. The
  /// plane of a face in the ball always does.
  [[nodiscard]] Known look(const Ball& ball, Operand& operand) const {
    const Body& body = bodies_.bodies[operand.body];
    if (operand.tests.size() == body.faces.size()) {
      const double far = glm::distance(ball.middle, body.middle);
      if (far > body.outer + ball.radius) return {true, {}};
      if (far < body.inner - ball.radius) return {true, {true, true}};
    }
    work_.charge(1 + operand.tests.size() / 4, converting);
    Numbers left;
    for (const std::uint32_t face : operand.tests) {
      const double height = bodies_.planes.height(body.faces[face].halfspace, ball.middle);
      if (height > ball.radius) return {true, {}};
      if (height >= -ball.radius) left.push_back(face);
    }
    if (left.empty()) return {true, {true, true}};
    operand.tests = std::move(left);
    return {};
  }

  /// Adds faces of the body. The tree holds the undecided operands, including the body itself.
  void add_group(std::span<std::uint32_t> faces, const LocalTree& tree, std::vector<Operand> operands) {
    constexpr std::size_t max_at_once = 4;
    const Ball ball = ball_about(faces);
    std::vector<Known> known(operands.size());
    std::vector<bool> is_left(operands.size(), true);
    bool any = false;
    for (std::size_t i = 0; i < operands.size(); ++i) {
      if (operands[i].body == own_) continue;
      known[i] = look(ball, operands[i]);
      if (known[i].is_known) is_left[i] = !(any = true);
    }
    std::optional<LocalTree> left;
    if (any) {
      left = tree.reduced(known, is_left);
      if (left->value().is_known) return;
      keep_operands(is_left, *left, operands);
    }
    const LocalTree& here = left ? *left : tree;
    if (faces.size() == 1) {
      add_face(own().faces[faces.front()], here, std::move(operands));
    } else if (faces.size() <= max_at_once) {
      for (std::size_t i = 0; i < faces.size(); ++i) add_group(faces.subspan(i, 1), here, operands);
    } else {
      const std::size_t half = faces.size() / 2;
      const int axis = widest_axis(faces);
      std::ranges::nth_element(faces, faces.begin() + static_cast<std::ptrdiff_t>(half), {},
                               [&](std::uint32_t face) { return middle_of(own().faces[face])[axis]; });
      add_group(faces.first(half), here, operands);
      add_group(faces.subspan(half), here, std::move(operands));
    }
  }

  /// The axis along which the centres of the faces are farthest apart.
  [[nodiscard]] int widest_axis(std::span<const std::uint32_t> faces) const {
    glm::dvec3 low = middle_of(own().faces[faces.front()]);
    glm::dvec3 high = low;
    for (const std::uint32_t face : faces) {
      low = glm::min(low, middle_of(own().faces[face]));
      high = glm::max(high, middle_of(own().faces[face]));
    }
    const glm::dvec3 size = high - low;
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  }

  /// Determines an operand's position relative to the plane of the face.
  void place(Operand& operand, const BodyFace& face) const {
    const facet::Halfspace halfspace = face.halfspace;
    if (operand.body == own_) {
      operand.known = {true, {halfspace.positive, !halfspace.positive}};
      return;
    }
    const Body& other = bodies_.bodies[operand.body];
    if (are_apart(other.box, face.box) || !meets_plane(other.box, halfspace.plane)) {
      operand.known = {true, {}};
      return;
    }
    for (const std::uint32_t test : operand.tests) {
      if (other.faces[test].halfspace.plane != halfspace.plane) continue;
      operand.is_coplanar = true;
      operand.is_behind = other.faces[test].halfspace.positive;
      operand.owns = operand.body < own_;
    }
  }

  /// Adds the whole face or nothing if the known operands decide that; returns whether they do.
  bool add_whole(const BodyFace& face, const LocalTree& tree, std::span<const Operand> operands) {
    std::vector<Known> known;
    std::vector<bool> may_differ;
    known.reserve(operands.size());
    may_differ.reserve(operands.size());
    for (const Operand& operand : operands) {
      known.push_back(operand.known);
      may_differ.push_back(operand.is_coplanar);
    }
    const LocalTree left = tree.reduced(known, may_differ);
    if (!left.value().is_known) return false;
    const SideValues value = left.value().value;
    if (value.behind == value.before) return true;
    const auto is_open = [](const Operand& operand) { return operand.owns && !operand.known.is_known; };
    if (std::ranges::any_of(operands, is_open)) return false;
    found_.push_back(fragment_of(sheet_, region_of(face), value.behind, own_, own().sides_of(face)));
    return true;
  }

  Region region_of(const BodyFace& face) {
    std::vector<std::uint32_t> sides;
    sides.reserve(face.sides);
    for (const BodySide& side : own().sides_of(face)) sides.push_back(side.plane);
    return sheet_.begin(face.halfspace.plane, sides);
  }

  void add_face(const BodyFace& face, const LocalTree& tree, std::vector<Operand> operands) {
    work_.charge(1 + operands.size(), converting);
    for (Operand& operand : operands) place(operand, face);
    if (!add_whole(face, tree, operands)) divide_(own_, face, region_of(face), tree, std::move(operands));
  }

  const Bodies& bodies_;
  const csg::PositiveTree& tree_;
  csg::TreePaths paths_;
  const Work& work_;
  Sheet sheet_;
  std::vector<Fragment> found_;
  Division divide_;
  std::uint32_t own_ = 0;  ///< the current body
};

/// Evaluates bodies on several threads; each thread takes one body after another.
class Sharing {
 public:
  Sharing(const Bodies& bodies, const csg::PositiveTree& tree, std::vector<std::uint32_t> numbers, const Work& work,
          const FragmentSink& sink)
      : bodies_(bodies), tree_(tree), numbers_(std::move(numbers)), work_(work), sink_(sink), found_(numbers_.size()) {}

  void operator()(std::size_t threads) {
    {
      std::vector<std::jthread> others;
      for (std::size_t i = 1; i < threads; ++i) others.emplace_back([this] { process_bodies(); });
      process_bodies();
    }
    if (failure_) std::rethrow_exception(failure_);
    work_.charge(done_, converting);
  }

 private:
  void process_bodies() {
    const Work work = work_.with_zero_count();  // counts of all threads are added up at the end
    try {
      Evaluation evaluation(bodies_, tree_, work);
      for (std::size_t i = next_++; i < numbers_.size(); i = next_++) {
        evaluation.add(numbers_[i]);
        add(i, evaluation.release());
      }
    } catch (...) {
      const std::lock_guard guard(lock_);
      failure_ = std::current_exception();
      next_ = numbers_.size();
    }
    const std::lock_guard guard(lock_);
    done_ += work.done();
  }

  /// Delivers the fragments of a body to the sink once those of all earlier bodies were delivered.
  void add(std::size_t number, std::vector<Fragment> found) {
    const std::lock_guard guard(lock_);
    found_[number] = std::move(found);
    for (; delivered_ < found_.size() && found_[delivered_]; ++delivered_) {
      sink_(*found_[delivered_]);
      found_[delivered_].reset();
    }
  }

  const Bodies& bodies_;
  const csg::PositiveTree& tree_;
  std::vector<std::uint32_t> numbers_;
  const Work& work_;
  const FragmentSink& sink_;
  std::vector<std::optional<std::vector<Fragment>>> found_;  ///< one per body
  std::size_t delivered_ = 0;
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
    // Corners are reversed: the side after a corner is the one that preceded it.
    const std::size_t at = is_front ? i : count - 1 - i;
    const std::size_t along = is_front ? at : (at + count - 1) % count;
    const std::uint32_t corner = region.corners[at];
    fragment.corners.push_back(
        {sheet.point(corner).planes, region.planes[along], corner < sides.size() ? sides[corner].vertex : no_vertex});
  }
  return fragment;
}

void find_fragments(const Bodies& bodies, const csg::PositiveTree& tree, const std::vector<bool>& whole,
                    const FragmentSink& sink, const Work& work, unsigned threads) {
  if (tree.root == model::no_index) return;
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < bodies.bodies.size(); ++i)
    if (!whole[i]) numbers.push_back(i);
  if (numbers.empty()) return;
  Sharing(bodies, tree, numbers, work, sink)(std::min<std::size_t>(threads, numbers.size()));
}

}  // namespace csgsim::software::convert
