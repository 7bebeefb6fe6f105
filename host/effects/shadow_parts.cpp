#include "host/effects/shadow_parts.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "host/effects/plane_comparison.h"
#include "host/effects/receiver_sides.h"

namespace csgsim::effects {

namespace {

/// Maximum number of clipping operations for the search of covered outlines, for all volumes of a region. After these,
/// no outline counts as covered.
constexpr std::uint64_t max_covering_work = 20'000'000;

/// Maximum number of uncovered parts of an outline; an outline with more counts as not covered.
constexpr std::size_t max_open = 24;

/// Work of clipping an outline by a plane, in steps.
constexpr std::uint64_t clip_steps = 4;

constexpr std::string_view finding_shadows = "finding where shadows fall";

bool overlap(const view::PixelRect& a, const view::PixelRect& b) { return !view::common(a, b).empty(); }

/// The part of a receiver that is inside a volume.
struct Touch {
  std::size_t receiver = 0;
  Outline outline;
  view::PixelRect pixels;
};

struct Volume {
  std::vector<ShadowPlane> planes;
  std::uint32_t primitive = 0;
  std::vector<Touch> touches;
};

/// The sides of all receivers, for each plane.
using SidesOfPlanes = std::vector<std::vector<ReceiverSide>>;

/// Volumes over receivers. Volumes and planes are removed as long as the shadowed part of the receivers stays the same.
class Covering {
 public:
  Covering(const std::vector<ShadowVolumeInView>& volumes, const Receivers& receivers, unsigned fraction_bits,
           const Work& work)
      : receivers_(receivers.facets),
        sides_(receivers_, fraction_bits),
        fraction_bits_(fraction_bits),
        work_(work),
        volumes_by_receiver_(receivers.facets.size()) {
    for (const ShadowVolumeInView& one : volumes) {
      Volume volume{one.planes, one.primitive, {}};
      volume.touches = touches(volume.planes);
      if (volume.touches.empty()) continue;
      for (const Touch& touch : volume.touches)
        volumes_by_receiver_[touch.receiver].push_back({volumes_.size(), touch.pixels});
      volumes_.push_back(std::move(volume));
    }
  }

  /// A volume with fewer planes covers more, so that other volumes may become redundant.
  void reduce() {
    remove_redundant();
    for (std::size_t i = 0; i < volumes_.size(); ++i) {
      if (!volumes_[i].touches.empty()) reduce_planes(i);
    }
    remove_redundant();
  }

  [[nodiscard]] ShadowParts take() const {
    ShadowParts result;
    for (const Volume& volume : volumes_) {
      if (volume.touches.empty()) continue;
      ShadowPart part{volume.planes, {}, volume.primitive};
      for (const Touch& touch : touches(volume.planes)) part.pixels = view::hull(part.pixels, touch.pixels);
      for (const Touch& touch : volume.touches) result.touched.push_back(touch.receiver);
      result.parts.push_back(std::move(part));
    }
    return result;
  }

 private:
  [[nodiscard]] PlaneComparison comparison(std::size_t receiver) const {
    return {receivers_[receiver].plane, fraction_bits_};
  }

  [[nodiscard]] SidesOfPlanes plane_sides(const std::vector<ShadowPlane>& planes) const {
    SidesOfPlanes sides;
    sides.reserve(planes.size());
    for (const ShadowPlane& plane : planes) sides_.decide(plane, sides.emplace_back(receivers_.size()));
    return sides;
  }

  /// For each receiver, the number of planes that it is certainly beyond.
  [[nodiscard]] std::vector<std::uint32_t> planes_before(const SidesOfPlanes& sides) const {
    std::vector<std::uint32_t> counts(receivers_.size());
    for (const std::vector<ReceiverSide>& of_plane : sides) {
      for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += of_plane[i] == ReceiverSide::beyond ? 1U : 0U;
    }
    return counts;
  }

  /// Clips an outline on a receiver by all planes except number `but`. Returns false if nothing is left.
  bool clip(Outline& outline, std::size_t receiver, const std::vector<ShadowPlane>& planes, const SidesOfPlanes& sides,
            std::size_t but) const {
    const PlaneComparison compared = comparison(receiver);
    for (std::size_t i = 0; i < planes.size(); ++i) {
      if (i == but || sides[i][receiver] == ReceiverSide::within) continue;
      if (!outline.clip(compared.in(planes[i]), spare_)) return false;
    }
    return !outline.empty();
  }

  [[nodiscard]] std::vector<Touch> touches(const std::vector<ShadowPlane>& planes) const {
    work_.charge(clip_steps * receivers_.size() * planes.size(), finding_shadows);
    const SidesOfPlanes sides = plane_sides(planes);
    const std::vector<std::uint32_t> before = planes_before(sides);
    std::vector<Touch> found;
    for (std::size_t i = 0; i < receivers_.size(); ++i) {
      if (before[i] > 0) continue;
      inside_ = receivers_[i].outline;
      if (clip(inside_, i, planes, sides, planes.size())) found.push_back({i, inside_, inside_.pixels()});
    }
    return found;
  }

  /// Appends the parts of an outline that may be outside the planes.
  void subtract(Outline outline, const PlaneComparison& compared, const std::vector<ShadowPlane>& planes,
                std::vector<Outline>& left) {
    covering_work_ += planes.size();
    crossed_.clear();
    for (const ShadowPlane& plane : planes) {
      const Outline::Position position = outline.position(compared.in(plane), compared.certainly_in());
      if (position == Outline::Position::beyond) {
        left.push_back(std::move(outline));
        return;
      }
      if (position == Outline::Position::across) crossed_.push_back(&plane);
    }
    for (const ShadowPlane* const plane : crossed_) {
      outside_ = outline;
      if (outside_.clip(compared.out(*plane), spare_)) left.push_back(outside_);
      if (!outline.clip(compared.in(*plane), spare_)) return;
    }
  }

  /// Whether volumes other than `but` cover all of `part`, a part of a receiver.
  [[nodiscard]] bool is_covered(std::size_t receiver, const Outline& part, std::size_t but) {
    if (covering_work_ > max_covering_work) return false;
    const PlaneComparison compared = comparison(receiver);
    const view::PixelRect pixels = part.pixels();
    std::vector<Outline> open{part};
    for (const auto& [index, rect] : volumes_by_receiver_[receiver]) {
      if (index == but || volumes_[index].touches.empty() || !overlap(rect, pixels)) continue;
      std::vector<Outline> left;
      for (Outline& one : open) subtract(std::move(one), compared, volumes_[index].planes, left);
      open = std::move(left);
      if (open.empty()) return true;
      if (open.size() > max_open) return false;
    }
    return false;
  }

  void remove_redundant() {
    for (std::size_t i = 0; i < volumes_.size(); ++i) {
      if (!volumes_[i].touches.empty() && is_redundant(i)) volumes_[i].touches.clear();
    }
  }

  [[nodiscard]] bool is_redundant(std::size_t index) {
    const std::vector<Touch>& all = volumes_[index].touches;
    return std::all_of(all.begin(), all.end(),
                       [&](const Touch& touch) { return is_covered(touch.receiver, touch.outline, index); });
  }

  /// Removes planes that only exclude regions that other volumes cover.
  void reduce_planes(std::size_t index) {
    std::vector<ShadowPlane>& planes = volumes_[index].planes;
    SidesOfPlanes sides = plane_sides(planes);
    std::vector<std::uint32_t> before = planes_before(sides);
    for (std::size_t i = 0; i < planes.size();) {
      if (is_plane_redundant(index, i, sides, before)) {
        for (std::size_t k = 0; k < before.size(); ++k) before[k] -= sides[i][k] == ReceiverSide::beyond ? 1U : 0U;
        planes.erase(planes.begin() + static_cast<std::ptrdiff_t>(i));
        sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(i));
      } else {
        ++i;
      }
    }
  }

  /// `sides` are those of the volume's planes, and `before` is planes_before() of them.
  [[nodiscard]] bool is_plane_redundant(std::size_t index, std::size_t plane, const SidesOfPlanes& sides,
                                        const std::vector<std::uint32_t>& before) {
    const std::vector<ShadowPlane>& planes = volumes_[index].planes;
    work_.charge(clip_steps * receivers_.size() * planes.size(), finding_shadows);
    for (std::size_t i = 0; i < receivers_.size(); ++i) {
      const ReceiverSide side = sides[plane][i];
      const std::uint32_t others = before[i] - (side == ReceiverSide::beyond ? 1U : 0U);
      // A receiver beyond another plane is not in the volume, and a receiver within this plane is not affected by it.
      if (others > 0 || side == ReceiverSide::within) continue;
      more_ = receivers_[i].outline;
      if (!more_.clip(comparison(i).out(planes[plane]), spare_) || !clip(more_, i, planes, sides, plane)) continue;
      if (!is_covered(i, more_, index)) return false;
    }
    return true;
  }

  const std::vector<Receiver>& receivers_;
  mutable ReceiverSides sides_;
  unsigned fraction_bits_;
  const Work& work_;
  std::vector<Volume> volumes_;  ///< a removed volume has no touches
  std::vector<std::vector<std::pair<std::size_t, view::PixelRect>>>
      volumes_by_receiver_;  ///< for each receiver: the volumes with pixels that touch it
  std::uint64_t covering_work_ = 0;

  // Scratch buffers that are reused to save allocations.
  mutable Outline spare_;
  mutable Outline inside_;
  Outline outside_;
  Outline more_;
  std::vector<const ShadowPlane*> crossed_;
};

}  // namespace

ShadowParts find_touching_parts(const std::vector<ShadowVolumeInView>& volumes, const Receivers& receivers,
                                unsigned fraction_bits, const Work& work) {
  Covering covering(volumes, receivers, fraction_bits, work);
  covering.reduce();
  ShadowParts result = covering.take();
  std::sort(result.touched.begin(), result.touched.end());
  result.touched.erase(std::unique(result.touched.begin(), result.touched.end()), result.touched.end());
  return result;
}

}  // namespace csgsim::effects
