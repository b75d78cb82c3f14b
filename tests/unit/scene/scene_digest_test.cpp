// Two copies of a scene have the same digest exactly when they give the same forces.
#include "core/scene/scene_digest.h"

#include <gtest/gtest.h>

#include "tests/unit/scene/loaded.h"

namespace fyd::scene {
namespace {

const std::string kScene = "[scene]\nname = \"a\"\n[[body]]\nmesh = \"a.obj\"\nstiffness_N_per_mm = 0.5\n";

TEST(SceneDigest, TellsApartWhatFeelsOtherwise) {
  const std::string digest = digestOf(*loaded(kScene, {shapes::bumps(10)}));
  EXPECT_EQ(digest.size(), 32U);
  const auto differs = [&digest](const std::string& text, TriangleSoup soup, const auto&... texture) {
    return digestOf(*loaded(text, {std::move(soup)}, texture...)) != digest;
  };
  EXPECT_TRUE(differs(kScene + "contact = \"facet\"\n", shapes::bumps(10)));
  EXPECT_TRUE(differs(kScene + "position_mm = [0, 0, 0.001]\n", shapes::bumps(10)));
  EXPECT_TRUE(differs(kScene + "[palpation]\n", shapes::bumps(10)));
  EXPECT_TRUE(differs(kScene, shapes::bumps(11)));
  EXPECT_TRUE(differs(kScene, shapes::bumps(10), ribbed()));
  TriangleSoup moved = shapes::bumps(10);
  moved.vertices[7].z += 1e-3;
  EXPECT_TRUE(differs(kScene, moved));
  // A default that is spelled out, another name, comments and another order.
  EXPECT_FALSE(
      differs("# a copy\n[[body]]\nstiffness_N_per_mm = 0.50\nmesh = \"copies/b.obj\"\nname = \"hill\"\n"
              "contact = \"automatic\"\n[scene]\nname = \"b\"\n",
              shapes::bumps(10)));
}

TEST(SceneDigest, AStoredSurfacesNameCountsOnlyForASavedState) {
  texture::SurfaceModel other = ribbed();
  other.name = "a copy of ribbed";
  other.description = "by hand";
  const auto one = loaded(kScene, {shapes::bumps(10)}, ribbed()), two = loaded(kScene, {shapes::bumps(10)}, other);
  EXPECT_EQ(digestOf(*one), digestOf(*two));
  EXPECT_NE(felt(one).digestOfState(), felt(two).digestOfState());
  other.bands[0].rms_g = 0.31;
  EXPECT_NE(digestOf(*one), digestOf(*loaded(kScene, {shapes::bumps(10)}, other)));
  const auto plain = loaded(kScene, {shapes::bumps(10)});
  EXPECT_EQ(felt(plain).digestOfState(), digestOf(*plain));
}

/// A literal from another run: of every machine and compiler the same.
TEST(SceneDigest, IsTheSameEverywhere) {
  EXPECT_EQ(digestOf(*loaded(kScene, {shapes::box(1.0, 2.0, 3.0)})), "e7e92ced19dcd255d9746699ac305ec6");
}

}  // namespace
}  // namespace fyd::scene
