#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/solids/read_mesh.h"
#include "host/solids/words.h"
#include "hw/base/error.h"

namespace csgsim::solids {

namespace {

// The format is G. Turk's, "The PLY Polygon File Format" (1994): a header in text that describes the elements, then
// their values as text or in binary.

enum class PlyForm : std::uint8_t { text, little_endian, big_endian };

/// Type of a number in binary.
struct PlyType {
  std::string_view name;
  std::string_view other_name;
  std::size_t bytes;
  bool is_signed;
  bool is_real;
};

constexpr auto ply_types = std::to_array<PlyType>({{"char", "int8", 1, true, false},
                                                   {"uchar", "uint8", 1, false, false},
                                                   {"short", "int16", 2, true, false},
                                                   {"ushort", "uint16", 2, false, false},
                                                   {"int", "int32", 4, true, false},
                                                   {"uint", "uint32", 4, false, false},
                                                   {"float", "float32", 4, true, true},
                                                   {"double", "float64", 8, true, true}});

/// A property of an element: a number, or a list of numbers after their count.
struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count;  ///< set for a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyForm form = PlyForm::text;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  ///< bytes of the header
};

constexpr std::size_t max_elements = 100;
constexpr std::size_t max_properties = 1000;  ///< number in all elements together
constexpr std::string_view end_of_header = "end_header";

/// Bytes of the header, including the end of its last line.
std::size_t header_size(std::string_view bytes, std::string_view name) {
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    std::string_view line = bytes.substr(at, end - at);
    if (line.ends_with('\r')) line.remove_suffix(1);
    at = end + 1;
    if (line == end_of_header) return std::min(at, bytes.size());
  }
  throw InputError(fmt::format("{}: the header of a PLY file must end with 'end_header'; export it again", name));
}

class PlyHeaderReader {
 public:
  PlyHeaderReader(std::string_view header, std::string_view name) : words_(header, name) {}

  PlyHeader read() {
    if (words_.next() != "ply") words_.fail("a PLY file must start with 'ply'; export it as PLY again");
    bool has_format = false;
    for (std::string_view word = words_.next(); word != end_of_header; word = words_.next()) {
      if (word == "format") {
        read_form();
        has_format = true;
      } else if (word == "element") {
        read_element();
      } else if (word == "property") {
        read_property();
      } else if (word != "comment" && word != "obj_info") {
        words_.fail("expected 'format', 'element', 'property', 'comment' or 'end_header'; export it as PLY again");
      }
      words_.skip_line();
    }
    if (!has_format) words_.fail("the header names no format; export it as PLY again");
    return std::move(header_);
  }

 private:
  void read_form() {
    const std::string_view word = words_.next_on_line();
    if (word == "ascii") {
      header_.form = PlyForm::text;
    } else if (word == "binary_little_endian") {
      header_.form = PlyForm::little_endian;
    } else if (word == "binary_big_endian") {
      header_.form = PlyForm::big_endian;
    } else {
      words_.fail("the format must be ascii, binary_little_endian or binary_big_endian; export it as PLY again");
    }
  }

  void read_element() {
    if (header_.elements.size() == max_elements)
      words_.fail(fmt::format("more than {} elements; export the mesh alone", max_elements));
    PlyElement& element = header_.elements.emplace_back();
    element.name = words_.next_on_line();
    element.count = words_.count("the number of elements", 0xffffffffU);
  }

  void read_property() {
    if (header_.elements.empty()) words_.fail("a property before the first element; export it as PLY again");
    if (++properties_ > max_properties)
      words_.fail(fmt::format("more than {} properties; export only points and faces", max_properties));
    PlyProperty& property = header_.elements.back().properties.emplace_back();
    std::string_view word = words_.next_on_line();
    if (word == "list") {
      property.count = type_of(words_.next_on_line());
      if (property.count->is_real) words_.fail("the count of a list must be a whole number; export it as PLY again");
      word = words_.next_on_line();
    }
    property.type = type_of(word);
    property.name = words_.next_on_line();
  }

  PlyType type_of(std::string_view word) {
    const auto found = std::ranges::find_if(
        ply_types, [&](const PlyType& type) { return word == type.name || word == type.other_name; });
    if (found == ply_types.end())
      words_.fail(fmt::format("unknown type '{}'; export it as PLY again", word.substr(0, 40)));
    return *found;
  }

  Words words_;
  PlyHeader header_;
  std::size_t properties_ = 0;
};

/// Numbers in text.
class PlyText {
 public:
  PlyText(std::string_view text, std::string_view name) : words_(text, name) {
    for (std::string_view word = words_.next(); !word.empty() && word != end_of_header; word = words_.next())
      words_.skip_line();
    words_.skip_line();
  }

  double number(const PlyType& /*type*/) { return words_.number("a value"); }
  [[noreturn]] void fail(std::string_view message) const { words_.fail(message); }

 private:
  Words words_;
};

/// Numbers in binary.
class PlyBinary {
 public:
  PlyBinary(std::string_view bytes, PlyForm form, std::size_t header, std::string_view name)
      : bytes_(bytes), name_(name), form_(form), at_(header) {}

  double number(const PlyType& type) {
    if (bytes_.size() - at_ < type.bytes) fail("the file ends before its last element; export it again");
    std::uint64_t raw = 0;
    for (std::size_t i = 0; i < type.bytes; ++i) {
      const std::size_t from = form_ == PlyForm::big_endian ? i : type.bytes - 1 - i;
      raw = raw << 8U | static_cast<unsigned char>(bytes_[at_ + from]);
    }
    at_ += type.bytes;
    return value_of(raw, type);
  }

  [[noreturn]] void fail(std::string_view message) const {
    throw InputError(fmt::format("{}: at byte {}: {}", name_, at_, message));
  }

 private:
  double value_of(std::uint64_t raw, const PlyType& type) const {
    if (type.is_real) {
      const double value = type.bytes == 4 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(raw)))
                                           : std::bit_cast<double>(raw);
      if (!std::isfinite(value)) fail("a value is not finite; correct it");
      return value;
    }
    const auto unused = static_cast<unsigned>(64 - 8 * type.bytes);
    if (type.is_signed) return static_cast<double>(static_cast<std::int64_t>(raw << unused) >> unused);
    return static_cast<double>(raw);
  }

  std::string_view bytes_;
  std::string_view name_;
  PlyForm form_;
  std::size_t at_;
};

/// Builds the mesh from the elements `vertex` and `face`; other elements and properties are skipped.
template <class Numbers>
class PlyBody {
 public:
  PlyBody(Numbers numbers, const PlyHeader& header) : numbers_(std::move(numbers)), header_(header) {}

  Mesh read() {
    require_elements();
    for (const PlyElement& element : header_.elements) {
      for (std::uint64_t i = 0; i < element.count; ++i) {
        if (element.name == "vertex") {
          read_point(element);
        } else if (element.name == "face") {
          read_face(element);
        } else {
          for (const PlyProperty& property : element.properties) skip(property);
        }
      }
    }
    return std::move(mesh_);
  }

 private:
  static bool is_corners(const PlyProperty& property) {
    return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
  }

  static bool has_property(const PlyElement& element, std::string_view name) {
    return std::ranges::any_of(element.properties,
                               [&](const PlyProperty& one) { return !one.count && one.name == name; });
  }

  [[nodiscard]] const PlyElement* element_named(std::string_view name) const {
    const auto found = std::ranges::find(header_.elements, name, &PlyElement::name);
    return found == header_.elements.end() ? nullptr : &*found;
  }

  /// An element without properties would repeat without reading a byte.
  void require_elements() const {
    for (const PlyElement& element : header_.elements)
      if (element.properties.empty() && element.count > 0)
        numbers_.fail(
            fmt::format("the element '{}' has no property; export it as PLY again", element.name.substr(0, 40)));
    const PlyElement* const vertex = element_named("vertex");
    const bool has_points =
        vertex != nullptr && has_property(*vertex, "x") && has_property(*vertex, "y") && has_property(*vertex, "z");
    if (!has_points) numbers_.fail("no element 'vertex' with x, y and z; export it as PLY again");
    const PlyElement* const face = element_named("face");
    if (face == nullptr || std::ranges::none_of(face->properties, is_corners))
      numbers_.fail(
          "no element 'face' with a list vertex_indices; it may be a cloud of points: export a mesh of faces");
  }

  void read_point(const PlyElement& element) {
    glm::dvec3& point = mesh_.points.emplace_back(0.0);
    for (const PlyProperty& property : element.properties) {
      const bool is_coordinate =
          !property.count && property.name.size() == 1 && property.name >= "x" && property.name <= "z";
      if (is_coordinate) {
        point[property.name[0] - 'x'] = numbers_.number(property.type);
      } else {
        skip(property);
      }
    }
  }

  void read_face(const PlyElement& element) {
    if (mesh_.faces.size() == max_mesh_faces)
      numbers_.fail(fmt::format("more than {} faces; make the mesh coarser", max_mesh_faces));
    for (const PlyProperty& property : element.properties) {
      if (is_corners(property)) {
        read_corners(property);
      } else {
        skip(property);
      }
    }
  }

  /// Reads the count of a list.
  std::uint32_t count(const PlyProperty& property) {
    const double number = numbers_.number(*property.count);
    const bool is_count = number >= 0 && number <= std::numeric_limits<std::uint32_t>::max();
    if (!is_count || number != std::floor(number))
      numbers_.fail("the count of a list must be a whole number, 0 or more; correct it");
    return static_cast<std::uint32_t>(number);
  }

  void read_corners(const PlyProperty& property) {
    const std::uint32_t corners = count(property);
    if (corners < 3) numbers_.fail("a face needs at least 3 corners; complete or remove it");
    auto& face = mesh_.faces.emplace_back();
    const std::size_t points = mesh_.points.size();
    for (std::uint32_t i = 0; i < corners; ++i) {
      const double corner = numbers_.number(property.type);
      const bool is_point = corner >= 0 && corner < static_cast<double>(points) && corner == std::floor(corner);
      if (!is_point)
        numbers_.fail(
            fmt::format("a corner must be one of the {} points before it, counted from 0; correct it", points));
      face.push_back(static_cast<std::uint32_t>(corner));
    }
  }

  void skip(const PlyProperty& property) {
    const std::uint32_t numbers = property.count ? count(property) : 1;
    for (std::uint32_t i = 0; i < numbers; ++i) numbers_.number(property.type);
  }

  Numbers numbers_;
  const PlyHeader& header_;
  Mesh mesh_;
};

}  // namespace

Mesh parse_ply(std::string_view text, std::string_view name) {
  const std::size_t size = header_size(text, name);
  PlyHeader header = PlyHeaderReader(text.substr(0, size), name).read();
  if (header.form == PlyForm::text) return PlyBody(PlyText(text, name), header).read();
  return PlyBody(PlyBinary(text, header.form, size, name), header).read();
}

}  // namespace csgsim::solids
