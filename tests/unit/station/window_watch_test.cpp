// The watch on the window's heartbeat: when a silence is reported.
#include "core/station/window_watch.h"

#include <gtest/gtest.h>

namespace fyd::station {
namespace {

using std::chrono::milliseconds;

TEST(WindowWatch, NobodyIsWaitedForBeforeTheFirstSign) {
  WindowWatch watch;
  EXPECT_FALSE(watch.fellSilent(instantAt(1.0)));
  EXPECT_FALSE(watch.fellSilent(instantAt(3600.0)));
}

TEST(WindowWatch, ASilenceIsToldOnceAndTheNextAfterAnotherSign) {
  WindowWatch watch;
  const Instant start = instantAt(5.0);
  watch.alive(start);
  EXPECT_FALSE(watch.fellSilent(start + milliseconds(500)));
  EXPECT_TRUE(watch.fellSilent(start + milliseconds(501)));
  EXPECT_FALSE(watch.fellSilent(start + milliseconds(502)));
  watch.alive(start + milliseconds(600));
  EXPECT_FALSE(watch.fellSilent(start + milliseconds(601)));
  EXPECT_TRUE(watch.fellSilent(start + milliseconds(1200)));
}

TEST(WindowWatch, ASignFromAfterTheCyclesStartIsNoSilence) {
  WindowWatch watch;
  watch.alive(instantAt(7.0));
  EXPECT_FALSE(watch.fellSilent(instantAt(6.0)));
}

}  // namespace
}  // namespace fyd::station
