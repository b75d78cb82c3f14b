// Mesh files: OBJ, STL and PLY, units, number formats, refusal of invalid files.
#include "core/scene/mesh/mesh_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <numeric>

namespace fyd::scene {
namespace {

const std::string kSquare = "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nf 1 2 3 4\n";

template <class T>
void put(std::string& to, T value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  to.append(bytes, sizeof value);
}

std::string binaryStl(std::uint32_t says, std::uint32_t holds) {
  std::string out(80, ' ');
  put(out, says);
  for (std::uint32_t t = 0; t < holds; ++t) {
    for (const float v : {0.F, 0.F, 1.F, float(t), 0.F, 0.F, float(t) + 1.F, 0.F, 0.F, float(t), 1.F, 0.F}) put(out, v);
    put(out, std::uint16_t{0});
  }
  return out;
}

TEST(MeshText, APolygonIsCutIntoTriangles) {
  const auto soup = parseMesh(kSquare, MeshFormat::obj, LengthUnit::mm);
  ASSERT_TRUE(soup.has_value()) << soup.error().text();
  EXPECT_EQ(soup->vertices.size(), 4U);
  ASSERT_EQ(soup->triangles.size(), 2U);
  EXPECT_DOUBLE_EQ(Mesh::build(*soup)->report().area_mm2, 6.0);
}

TEST(MeshText, UnitsAreMillimetres) {
  for (const auto& [unit, factor] :
       {std::pair(LengthUnit::mm, 1.0), {LengthUnit::cm, 10.0}, {LengthUnit::m, 1000.0}, {LengthUnit::in, 25.4}}) {
    const auto soup = parseMesh(kSquare, MeshFormat::obj, unit);
    ASSERT_TRUE(soup.has_value());
    EXPECT_DOUBLE_EQ(soup->vertices[2].y, 3.0 * factor);
  }
}

TEST(MeshText, NumbersAreReadInFull) {
  const auto soup =
      parseMesh("v 0.1234567890123456 0 0\nv 2 0 1e-300\nv 2 3 0\nf 1 2 3\n", MeshFormat::obj, LengthUnit::mm);
  ASSERT_TRUE(soup.has_value());
  EXPECT_EQ(soup->vertices[0].x, 0.1234567890123456);
}

TEST(MeshText, StlAndPlyInTextAndBinary) {
  const std::string stl =
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid "
      "a\n";
  EXPECT_EQ(parseMesh(stl, MeshFormat::stl, LengthUnit::mm)->triangles.size(), 1U);
  EXPECT_EQ(parseMesh(binaryStl(3, 3), MeshFormat::stl, LengthUnit::mm)->triangles.size(), 3U);
  const std::string head =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int "
      "vertex_indices\nend_header\n";
  EXPECT_EQ(
      parseMesh("ply\nformat ascii 1.0\n" + head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", MeshFormat::ply, LengthUnit::mm)
          ->triangles.size(),
      1U);
  std::string binary = "ply\nformat binary_little_endian 1.0\n" + head;
  for (const float v : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) put(binary, v);
  put(binary, std::uint8_t{3});
  for (const std::int32_t v : {0, 1, 2}) put(binary, v);
  EXPECT_EQ(parseMesh(binary, MeshFormat::ply, LengthUnit::mm)->triangles.size(), 1U);
}

TEST(MeshText, WhatIsNoMeshIsRefused) {
  const auto refused = [](const std::string& bytes, MeshFormat format) {
    const auto soup = parseMesh(bytes, format, LengthUnit::mm);
    return !soup.has_value() || !Mesh::build(*soup).has_value();
  };
  for (const MeshFormat format : {MeshFormat::obj, MeshFormat::stl, MeshFormat::ply}) {
    EXPECT_TRUE(refused("", format));
    EXPECT_TRUE(refused(std::string(1000, '\0'), format));
    EXPECT_TRUE(refused("mesh = \"this.toml\"\n", format));
  }
  EXPECT_TRUE(refused(kSquare + "f 1 2 99\n", MeshFormat::obj));
  EXPECT_TRUE(refused("v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", MeshFormat::obj));
  EXPECT_TRUE(refused(binaryStl(4'000'000'000U, 2), MeshFormat::stl));
  EXPECT_TRUE(refused(binaryStl(3, 3).substr(0, 150), MeshFormat::stl)) << "cut short";
  EXPECT_TRUE(
      refused("ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float "
              "z\nend_header\n0 0 0\n",
              MeshFormat::ply));
}

TEST(MeshText, APlyHeaderThatIsWrongIsRefusedBeforeItIsRead) {
  const auto errorOf = [](const std::string& header) {
    const auto soup = parseMesh(header + "0 0 0\n", MeshFormat::ply, LengthUnit::mm);
    return soup ? std::string() : soup.error().text();
  };
  const std::string good = "ply\nformat ascii 1.0\nelement vertex 1\n";
  EXPECT_NE(errorOf("ply\nformat ascii 1.0\nproperty float x\nend_header\n").find("line 3 \"property float x\""),
            std::string::npos)
      << "of no element";
  EXPECT_NE(errorOf(good + "property real x\nend_header\n").find("line 4"), std::string::npos);
  EXPECT_NE(errorOf(good + "property float x\nproperty float y\nend_header\n").find("line 6"), std::string::npos);
  EXPECT_NE(errorOf("ply\nformat ascii 2.0\n").find("line 2"), std::string::npos);
  EXPECT_EQ(parseMesh("ply\nformat ascii 1.0\n", MeshFormat::ply, LengthUnit::mm).error().text(),
            "the ply header does not end");
}

TEST(MeshText, APlyHeaderThatWouldEndOrHoldItsReaderIsRefused) {
  const std::string vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
  const auto errorOf = [](const std::string& elements) {
    const auto soup = parseMesh("ply\nformat ascii 1.0\n" + elements + "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                                MeshFormat::ply, LengthUnit::mm);
    return soup ? std::string() : soup.error().text();
  };
  const std::string mesh = vertices + faces;
  ASSERT_EQ(errorOf(mesh), "");
  const auto with = [&](const std::string& old, const std::string& now) {
    std::string out = mesh;
    return out.replace(out.find(old), old.size(), now);
  };
  std::string many;
  for (int i = 0; i < 100; ++i) many += "element e" + std::to_string(i) + " 0\nproperty int i\n";
  for (const std::string& elements : {
           many + mesh,
           with("float z", "short z"),                       // a place that is no real number
           with("float z", "list uchar float z"),            // or many
           "element vertices 1\nproperty short x\n" + mesh,  // by another name
           with("element face", "element halfedge 1\nproperty int source\nelement face"),
           with("uchar int", "int int"),      // two billion corners of three bytes
           with("uchar int", "double int"),   // a count that is no integer
           with("uchar int", "uchar short"),  // corners that are never looked at
           "element nothing 20\n" + mesh,     // many items of no bytes
           vertices + mesh,
           vertices + faces + "property uchar red\nproperty float green\nproperty uchar g\nproperty uchar blue\n",
       }) {
    EXPECT_NE(errorOf(elements).find("ply header, line "), std::string::npos) << elements << errorOf(elements);
  }
  EXPECT_NE(errorOf(with("float z", "short z")).find("line 6 \"property short z\""), std::string::npos)
      << "where it is";
}

TEST(MeshText, WhatElseAPlyFileHasIsPassedOver) {
  const auto soup = parseMesh(
      "ply\nformat ascii 1.0\ncomment made by hand\nobj_info none\nelement vertex 3\nproperty double x\nproperty "
      "float32 y\n"
      "property float64 z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement material 1\n"
      "property int number\nelement face 1\nproperty uchar flags\nproperty list uint8 uint32 vertex_index\nend_header\n"
      "0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 0 0 255\n7\n1 3 0 1 2\n",
      MeshFormat::ply, LengthUnit::mm);
  ASSERT_TRUE(soup) << soup.error().text();
  EXPECT_EQ(soup->triangles.size(), 1U);
  EXPECT_EQ(soup->vertices[1].x, 1.0);
}

TEST(MeshText, ByTheEndOfTheName) {
  EXPECT_EQ(meshFormatOf("a/B.STL").value(), MeshFormat::stl);
  EXPECT_EQ(meshFormatOf("a.b.obj").value(), MeshFormat::obj);
  for (const char* name : {"", "obj", "a.toml", "a.", ".obj/x"}) EXPECT_FALSE(meshFormatOf(name).has_value()) << name;
}

}  // namespace
}  // namespace fyd::scene
