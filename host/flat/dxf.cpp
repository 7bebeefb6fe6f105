#include "host/flat/dxf.h"

#include <cmath>
#include <map>
#include <utility>

#include "host/flat/clipping.h"
#include "host/flat/dxf/entities.h"
#include "host/flat/dxf/segments.h"
#include "host/flat/dxf/tags.h"
#include "host/model/degrees.h"
#include "hw/base/error.h"

namespace csgsim::flat {

namespace {

enum class Section { other, blocks, entities };

class DxfReader {
 public:
  explicit DxfReader(const DxfOptions& options) : options_(options) {}

  Area read(std::string_view bytes);

 private:
  void begin(const dxf::Tag& tag);
  void take(const dxf::Tag& tag);
  void finish();
  void finish_entity();
  void insert();
  void add(const dxf::Segment& segment);
  [[nodiscard]] bool is_selected() const {
    return section_ != Section::entities || options_.layer.empty() || options_.layer == entity_.layer;
  }

  DxfOptions options_;
  Section section_ = Section::other;
  dxf::Entity entity_;
  std::string block_;  ///< name of the block under definition
  std::map<std::string, std::vector<dxf::Segment>> blocks_;
  std::size_t block_segments_ = 0;
  dxf::Segments segments_;
};

void DxfReader::begin(const dxf::Tag& tag) {
  entity_ = {};
  entity_.type = tag.value;
  entity_.line = tag.line;
  if (entity_.type == "INSERT") entity_.first = entity_.second = 1;
}

/// Stores a group of the current entity. Blocks keep raw coordinates and lengths until they are inserted.
void DxfReader::take(const dxf::Tag& tag) {
  if (tag.code == 2) entity_.name = tag.value;
  if (tag.code == 8) entity_.layer = tag.value;
  if (section_ == Section::other) return;
  const bool raw = section_ == Section::blocks;
  switch (tag.code) {
    case 10:
    case 11:
      entity_.xs.push_back(raw ? parse_real(tag) : (parse_real(tag) - options_.origin.x) * options_.scale);
      break;
    case 20:
    case 21:
      entity_.ys.push_back(raw ? parse_real(tag) : (parse_real(tag) - options_.origin.y) * options_.scale);
      break;
    case 40: entity_.size = raw ? parse_real(tag) : parse_real(tag) * options_.scale; break;
    case 41: entity_.first = parse_real(tag); break;
    case 42: entity_.second = parse_real(tag); break;
    case 50: entity_.start = parse_real(tag); break;
    case 51: entity_.stop = parse_real(tag); break;
    case 70: entity_.flags = parse_integer(tag); break;
    default: break;
  }
}

void DxfReader::add(const dxf::Segment& segment) {
  if (section_ == Section::entities) {
    segments_.add(segment[0], segment[1]);
  } else if (!block_.empty()) {
    if (++block_segments_ > dxf::max_segments) {
      throw InputError("the blocks have more than " + std::to_string(dxf::max_segments) + " segments; simplify them");
    }
    blocks_[block_].push_back({segments_.snap(segment[0]), segments_.snap(segment[1])});
  }
}

void DxfReader::insert() {
  const auto found = blocks_.find(entity_.name);
  if (found == blocks_.end()) return;
  const glm::dvec2 place = dxf::point(entity_, 0);
  const double sine = model::sin_degrees(entity_.start);
  const double cosine = model::cos_degrees(entity_.start);
  const auto placed = [&](const glm::dvec2& point) {
    const glm::dvec2 scaled = point * glm::dvec2(entity_.first, entity_.second);
    const glm::dvec2 turned(cosine * scaled.x - sine * scaled.y, sine * scaled.x + cosine * scaled.y);
    return turned * options_.scale + place;
  };
  const std::vector<dxf::Segment> block = found->second;  // a copy, since the block grows if it is inserted into itself
  for (const dxf::Segment& segment : block) add({placed(segment[0]), placed(segment[1])});
}

void DxfReader::finish_entity() {
  if (section_ == Section::other || !is_selected()) return;
  if (dxf::is_drawn(entity_.type)) {
    dxf::draw(entity_, options_.facets, [&](const dxf::Segment& segment) { add(segment); });
  } else if (entity_.type == "INSERT") {
    insert();
  }
}

void DxfReader::finish() {
  if (entity_.type == "SECTION") {
    section_ = entity_.name == "ENTITIES" ? Section::entities
               : entity_.name == "BLOCKS" ? Section::blocks
                                          : Section::other;
  } else if (entity_.type == "BLOCK") {
    block_ = entity_.name;
  } else if (entity_.type == "ENDBLK") {
    block_.clear();
  } else {
    try {
      finish_entity();
    } catch (const InputError& error) {
      throw InputError("line " + std::to_string(entity_.line) + ": " + error.what());
    }
  }
}

Area DxfReader::read(std::string_view bytes) {
  dxf::Tags tags(bytes);
  bool any = false;
  while (const std::optional<dxf::Tag> tag = tags.next()) {
    if (tag->code == 0) {
      finish();
      begin(*tag);
      any = any || tag->value == "SECTION";
    } else {
      take(*tag);
    }
  }
  if (!any) throw InputError("line 1: not a DXF file: no section found; save it as ASCII DXF");
  if (entity_.type != "EOF") throw InputError("the DXF file is truncated: its last group is not 0, EOF; save it again");
  return even_odd_area(to_paths({segments_.outlines()}), options_.work);
}

}  // namespace

Area read_dxf(std::string_view bytes, const DxfOptions& options) {
  if (!(options.scale > 0) || !std::isfinite(options.scale) || !std::isfinite(options.origin.x) ||
      !std::isfinite(options.origin.y)) {
    throw InputError("the scale of import() must be above 0, and its origin must have finite coordinates");
  }
  return DxfReader(options).read(bytes);
}

}  // namespace csgsim::flat
