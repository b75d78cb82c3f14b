// fyd sim …: the simulated partners of a session, each as its own process.
#include "app/cli/parts/command.h"
#include "app/cli/parts/end_options.h"
#include "app/cli/parts/process_options.h"
#include "app/cli/sim/sim_krc.h"
#include "app/cli/sim/sim_network.h"
#include "app/cli/sim/sim_touchpad.h"
#include "core/sim/robot/robot_arm.h"

namespace fyd::cli {
namespace {

struct SimRobotOptions {
  EndOptions end;
  MaterialOptions material;
};

void addRobot(CLI::App& sim) {
  auto options = std::make_shared<SimRobotOptions>();
  CLI::App* robot = sim.add_subcommand("robot", "The robot's end of either protocol with a simulated arm");
  addEndOptions(*robot, options->end);
  addMaterialOptions(*robot, options->material);
  robot->callback([options] {
    runRobotEnd(options->end, runnerOptions(options->end, "fyd sim robot " FYD_VERSION),
                std::make_unique<sim::RobotArm>(simParameters(options->material)), {});
  });
}

}  // namespace

void add_sim(CLI::App& app) {
  CLI::App* sim = app.add_subcommand("sim", "Simulated partners that speak the real protocols");
  sim->require_subcommand(1);
  addRobot(*sim);
  addSimTouchpad(*sim);
  addSimKrc(*sim);
  addSimNetwork(*sim);
}

}  // namespace fyd::cli
