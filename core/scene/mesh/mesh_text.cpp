#include "core/scene/mesh/mesh_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <istream>
#include <sstream>
#include <utility>
#include <vector>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/stream.hpp>

namespace fyd::scene {

namespace {

constexpr std::size_t kLongestQuoted = 60;
constexpr std::size_t kMostPlyElements = 100;  // far more than any file has

struct PlyProperty {
  std::string name, type;
  std::string type_of_count;  // of a list; else empty
};

struct PlyElement {
  std::string name;
  std::vector<PlyProperty> properties;
};

template <class Words = std::initializer_list<std::string_view>>
bool isOneOf(const Words& words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

constexpr std::array<std::string_view, 8> kShortIntegers = {"char",  "int8",  "uchar",  "uint8",
                                                            "short", "int16", "ushort", "uint16"};
constexpr std::array<std::string_view, 4> kLongIntegers = {"int", "int32", "uint", "uint32"};
constexpr std::array<std::string_view, 4> kReals = {"float", "float32", "double", "float64"};

/// CGAL's other names for both, and one that has no meaning here.
bool isAnotherName(std::string_view element) { return isOneOf({"vertices", "faces", "halfedge"}, element); }

/// It has the type that CGAL takes for granted where it looks it up by its name.
bool isReadable(const PlyProperty& property, const PlyElement& of) {
  const bool list = !property.type_of_count.empty();
  // A longer count than of 16 bits lets a list of a small file fill the memory.
  if (list && (of.name == "vertex" || !isOneOf(kShortIntegers, property.type_of_count))) return false;
  if (isOneOf(kReals, property.type)) return true;
  if (of.name == "vertex" && isOneOf({"x", "y", "z"}, property.name)) return false;
  return isOneOf(kShortIntegers, property.type) || isOneOf(kLongIntegers, property.type);
}

/// What CGAL needs of an element is there, once.
bool isComplete(const PlyElement& element) {
  const auto named = [&](std::string_view name) {
    return std::ranges::count(element.properties, name, &PlyProperty::name);
  };
  if (element.properties.empty()) return false;  // as many items as it likes, of no bytes
  for (const auto& [longer, shorter] : {std::pair("red", "r"), {"green", "g"}, {"blue", "b"}}) {
    if (named(longer) != 0 && named(shorter) != 0) return false;
  }
  if (element.name == "vertex") return named("x") == 1 && named("y") == 1 && named("z") == 1;
  return element.name != "face" || std::ranges::any_of(element.properties, [](const PlyProperty& each) {
           return isOneOf({"vertex_indices", "vertex_index"}, each.name) && !each.type_of_count.empty() &&
                  isOneOf(kLongIntegers, each.type);
         });
}

/// CGAL's reader does not check a PLY header, and a wrong one ends the program or holds it: so it is checked first.
Result<void> checkPlyHeader(std::string_view bytes) {
  std::size_t line_number = 0;
  std::vector<PlyElement> elements;
  const auto has = [&](std::string_view name) { return std::ranges::count(elements, name, &PlyElement::name) != 0; };
  while (!bytes.empty()) {
    const std::size_t end = bytes.find('\n');
    if (end == std::string_view::npos) break;
    const std::string text(bytes.substr(0, std::min<std::size_t>(end, kLongestQuoted)));
    std::istringstream line{std::string(bytes.substr(0, end))};
    bytes.remove_prefix(end + 1);
    ++line_number;
    const auto wrong = [&] {
      return fail(
          "ply header, line {} \"{}\": expected format 1.0, then elements vertex (x, y, z, each float or double) and "
          "face (a list vertex_indices, uchar int) with the types of their properties",
          line_number, text);
    };
    std::string word;
    line >> word;
    if (line_number == 1) {
      if (word != "ply") return wrong();
    } else if (line_number == 2) {
      std::string format, version;
      line >> format >> version;
      const bool good = isOneOf({"ascii", "binary_little_endian", "binary_big_endian"}, format);
      if (word != "format" || !good || version != "1.0") return wrong();
    } else if (word == "element") {
      PlyElement element;
      std::uint64_t count = 0;
      if (!(line >> element.name >> count) || count > bytes.size()) return wrong();
      if (!elements.empty() && !isComplete(elements.back())) return wrong();
      if (elements.size() == kMostPlyElements || has(element.name) || isAnotherName(element.name)) return wrong();
      if (element.name == "face" && !has("vertex")) return wrong();
      elements.push_back(std::move(element));
    } else if (word == "property") {
      PlyProperty property;
      line >> property.type;
      if (property.type == "list") line >> property.type_of_count >> property.type;
      line >> property.name;
      if (elements.empty() || property.name.empty() || !isReadable(property, elements.back())) return wrong();
      elements.back().properties.push_back(std::move(property));
    } else if (word == "end_header") {
      if (!has("face") || !isComplete(elements.back())) return wrong();
      return {};
    } else if (word != "comment" && word != "obj_info") {
      return wrong();
    }
  }
  return fail("the ply header does not end");
}

}  // namespace

double millimetresPer(LengthUnit unit) {
  constexpr std::array<double, kLengthUnits.size()> kMillimetres = {1.0, 10.0, 1000.0, 25.4};
  return kMillimetres[static_cast<std::size_t>(unit)];
}

Result<MeshFormat> meshFormatOf(std::string_view file_name) {
  std::string ending(file_name.substr(std::min(file_name.rfind('.'), file_name.size() - 1) + 1));
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  for (std::size_t i = 0; i < kMeshFormats.size(); ++i) {
    if (ending == kMeshFormats[i]) return static_cast<MeshFormat>(i);
  }
  return fail("{}: no mesh by its name; expected .obj, .stl or .ply", file_name);
}

Result<TriangleSoup> parseMesh(std::string_view bytes, MeshFormat format, LengthUnit unit) {
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  if (format == MeshFormat::ply) {
    if (auto good = checkPlyHeader(bytes); !good) return tl::unexpected(good.error());
  }
  bool read = false;
  try {
    boost::iostreams::stream<boost::iostreams::array_source> in(bytes.data(), bytes.size());
    switch (format) {
      case MeshFormat::obj: read = CGAL::IO::read_OBJ(in, points, polygons); break;
      case MeshFormat::stl: read = CGAL::IO::read_STL(in, points, polygons); break;
      case MeshFormat::ply: read = CGAL::IO::read_PLY(in, points, polygons); break;
    }
  } catch (const std::exception&) {
    read = false;
  }
  const std::string_view name = kMeshFormats[static_cast<std::size_t>(format)];
  if (!read) return fail("the {} bytes are no whole {} file", bytes.size(), name);
  if (points.size() >= kNoTriangle)
    return fail("{} vertices; at most {} can be counted", points.size(), kNoTriangle - 1);
  TriangleSoup out;
  const double scale = millimetresPer(unit);
  out.vertices.reserve(points.size());
  for (const Point& p : points) out.vertices.push_back({scale * p.x(), scale * p.y(), scale * p.z()});
  out.triangles.reserve(polygons.size());
  for (const auto& polygon : polygons) {
    for (const std::size_t vertex : polygon) {
      if (vertex >= points.size()) {
        return fail("a polygon has vertex {}; expected one of the {} of this {} file", vertex + 1, points.size(), name);
      }
    }
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const auto corner = [&](std::size_t k) { return static_cast<std::uint32_t>(polygon[k]); };
      out.triangles.push_back({corner(0), corner(i - 1), corner(i)});
    }
  }
  if (out.triangles.empty()) return fail("there is no triangle in the {} bytes of this {} file", bytes.size(), name);
  return out;
}

}  // namespace fyd::scene
