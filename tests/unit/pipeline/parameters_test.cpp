// The descriptions of the step's parameters, from which window and manual take everything, are complete.
#include "core/pipeline/parameters.h"

#include <gtest/gtest.h>

#include <set>

namespace fyd::pipeline {
namespace {

TEST(StepParameters, EachIsExplainedAndThoseThatMayChangeLiveHaveANameOfTheirOwn) {
  Parameters parameters;
  std::set<std::pair<std::string_view, std::string_view>> names;  // in each room
  std::size_t live = 0;
  for (const Parameter& parameter : bindParameters(parameters)) {
    const std::string_view room = parameter.id.substr(0, parameter.id.find('.'));
    EXPECT_TRUE(parameter.info.help.ends_with('.')) << parameter.id << ": " << parameter.info.help;
    EXPECT_EQ(parameter.info.name.empty(), !parameter.info.live) << parameter.id;
    if (!parameter.info.live) continue;
    ++live;
    EXPECT_TRUE(names.emplace(room, parameter.info.name).second) << parameter.id << ": " << parameter.info.name;
  }
  EXPECT_GT(live, 50U);
}

}  // namespace
}  // namespace fyd::pipeline
