#include "core/scene/loaded_scene.h"

namespace fyd::scene {

Result<std::vector<BodyChoice>> chooseModels(const LoadedScene& scene) {
  if (auto checked = checkMeshes(scene.description, scene.meshes); !checked) return tl::unexpected(checked.error());
  std::vector<BodyChoice> out;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const BodyDescription& body = scene.description.bodies[i];
    const std::optional<double> accuracy = scene.description.accuracy;
    const TriangleTree& tree = scene.meshes[i]->tree;
    BodyChoice& to = out.emplace_back();
    if (!body.soft && body.contact != ContactChoice::automatic) {  // the enumerator `automatic` comes before the models
      to.model.contact = static_cast<ContactModel>(static_cast<int>(body.contact) - 1);
    } else if (accuracy && body.soft) {
      auto chosen = chooseSoft(tree, materialOf(body), *accuracy);
      if (!chosen) return fail(about(body.name, chosen.error().message));
      to.model.resolution = chosen->chosen;
      to.soft = *chosen;
    } else if (accuracy) {
      to.contact = chooseContact(tree, {.stiffness_N_per_mm = body.stiffness_N_per_mm},
                                 {.radius_mm = body.radius_mm, .reach_mm = body.depth_mm}, *accuracy);
      to.model.contact = to.contact->chosen;
    }
  }
  return out;
}

std::vector<BodyModel> modelsOf(const std::vector<BodyChoice>& choices) {
  std::vector<BodyModel> models;
  models.reserve(choices.size());
  for (const BodyChoice& each : choices) models.push_back(each.model);
  return models;
}

Result<Scene> buildScene(const LoadedScene& scene, const std::vector<BodyModel>& models) {
  if (scene.textures.size() != scene.description.bodies.size()) {
    return fail("scene: {} textures; expected {}, as there are bodies", scene.textures.size(),
                scene.description.bodies.size());
  }
  return Scene::build(scene.description, scene.meshes, models);
}

}  // namespace fyd::scene
