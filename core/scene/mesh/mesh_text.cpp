#include "core/scene/mesh/mesh_text.h"

#include <algorithm>
#include <cctype>
#include <istream>
#include <sstream>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/stream.hpp>

namespace fyd::scene {

namespace {

constexpr std::size_t kLongestQuoted = 60;

/// CGAL's reader does not check a PLY header, and a wrong one ends the program: so it is checked first.
Result<void> checkPlyHeader(std::string_view bytes) {
  static constexpr std::array<std::string_view, 16> kTypes = {
      "char", "int8",  "uchar", "uint8",  "short", "int16",   "ushort", "uint16",
      "int",  "int32", "uint",  "uint32", "float", "float32", "double", "float64"};
  const auto known = [](const std::string& type) { return std::ranges::find(kTypes, type) != kTypes.end(); };
  std::size_t line_number = 0;
  std::string element;
  std::vector<std::string> vertex_properties;
  bool has_faces = false;
  while (!bytes.empty()) {
    const std::size_t end = bytes.find('\n');
    if (end == std::string_view::npos) break;
    const std::string text(bytes.substr(0, std::min<std::size_t>(end, kLongestQuoted)));
    std::istringstream line{std::string(bytes.substr(0, end))};
    bytes.remove_prefix(end + 1);
    ++line_number;
    const auto wrong = [&] {
      return fail(
          "ply header, line {} \"{}\": expected format 1.0, then elements vertex (x, y, z) and face (a list "
          "vertex_indices) with the types of their properties",
          line_number, text);
    };
    std::string word;
    line >> word;
    if (line_number == 1) {
      if (word != "ply") return wrong();
    } else if (line_number == 2) {
      std::string format, version;
      line >> format >> version;
      const bool good = format == "ascii" || format == "binary_little_endian" || format == "binary_big_endian";
      if (word != "format" || !good || version != "1.0") return wrong();
    } else if (word == "element") {
      std::uint64_t count = 0;
      if (!(line >> element >> count)) return wrong();
      if (count > bytes.size()) return wrong();
      if (vertex_properties.empty() && element == "face") return wrong();
    } else if (word == "property") {
      std::string type, of_count, name;
      line >> type;
      const bool list = type == "list";
      if (list) line >> of_count >> type;
      line >> name;
      if (element.empty() || name.empty() || !known(type) || (list && !known(of_count))) {
        return wrong();
      }
      if (element == "vertex" && list) return wrong();
      if (element == "vertex") vertex_properties.push_back(name);
      if (element == "face" && list && (name == "vertex_indices" || name == "vertex_index")) has_faces = true;
    } else if (word == "end_header") {
      for (const std::string axis : {"x", "y", "z"}) {
        if (std::ranges::count(vertex_properties, axis) != 1) return wrong();
      }
      return has_faces ? Result<void>{} : wrong();
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
