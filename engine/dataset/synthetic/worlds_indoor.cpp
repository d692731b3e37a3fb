// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "engine/dataset/synthetic/motion.h"
#include "engine/dataset/synthetic/patterns.h"
#include "engine/dataset/synthetic/random.h"
#include "engine/dataset/synthetic/world.h"

namespace svoscope::synthetic {
namespace {

/// Hands out seeds, one for each texture, in the order of building.
class Seeds {
 public:
  explicit Seeds(std::uint64_t seed) : seed_(seed) {}
  std::uint64_t operator()() { return mixSeed(seed_, ++count_); }

 private:
  std::uint64_t seed_, count_ = 0;
};

/// Faces of cartons, books and cabinets.
FaceTexture printedFaces(Scene& scene, Seeds& seeds, double texel) {
  return [&scene, &seeds, texel](double width, double height) {
    const std::uint64_t seed = seeds();
    Random random(seed);
    const Surface surface{width, height, texel, seed};
    const double mean = random.uniform(85, 170), contrast = random.uniform(50, 85);
    const double largest = 0.4 * std::min(width, height);
    return scene.addTexture(shapes(surface, mean, contrast, largest));
  };
}

/// Four walls, floor and ceiling around the origin.
void addShell(Scene& scene, Seeds& seeds, const Vec3& size) {
  const double x = 0.5 * size.x(), y = 0.5 * size.y(), z = size.z(), texel = 0.0035;
  const auto wall = [&](const Vec3& corner, const Vec3& along, double mean, float gain) {
    const cv::Mat image = pictureWall({along.norm(), z, texel, seeds()}, mean);
    scene.addQuad(corner, along, Vec3(0, 0, -z), scene.addTexture(image), gain);
  };
  wall({-x, y, z}, {2 * x, 0, 0}, 165, 1.0f);
  wall({x, y, z}, {0, -2 * y, 0}, 150, 0.9f);
  wall({x, -y, z}, {-2 * x, 0, 0}, 170, 0.95f);
  wall({-x, -y, z}, {0, 2 * y, 0}, 155, 0.88f);
  const cv::Mat ground = boards({2 * x, 2 * y, texel, seeds()}, 120, 0.16);
  scene.addQuad({-x, y, 0}, {2 * x, 0, 0}, {0, -2 * y, 0}, scene.addTexture(ground));
  const cv::Mat ceiling = plaster({2 * x, 2 * y, 0.006, seeds()}, 190, 0.15);
  scene.addQuad({-x, -y, z}, {2 * x, 0, 0}, {0, 2 * y, 0}, scene.addTexture(ceiling));
}

void addMiddleBoxes(Scene& scene, Seeds& seeds) {
  const FaceTexture faces = printedFaces(scene, seeds, 0.0025);
  addBox(scene, {-0.45, 0.35, 0}, {0.7, 0.5, 0.75}, 0.3, faces);
  addBox(scene, {-0.4, 0.38, 0.75}, {0.35, 0.3, 0.3}, 0.9, faces);
  addBox(scene, {0.55, 0.1, 0}, {0.5, 0.45, 0.5}, -0.4, faces);
  addBox(scene, {0.35, 0.95, 0}, {0.6, 0.4, 1.15}, 0.1, faces);
  addBox(scene, {-1.15, 0.9, 0}, {0.45, 0.45, 1.0}, 0.7, faces);
  addBox(scene, {1.3, 0.75, 0}, {0.4, 0.6, 0.8}, -0.2, faces);
  addBox(scene, {0.0, -0.2, 0}, {0.3, 0.25, 0.22}, 1.2, faces);
}

void addWallBoxes(Scene& scene, Seeds& seeds, const Vec3& size) {
  const FaceTexture faces = printedFaces(scene, seeds, 0.003);
  Random random(seeds());
  const double x = 0.5 * size.x() - 0.4, y = 0.5 * size.y() - 0.4;
  for (int i = 0; i < 10; ++i) {
    const double along = random.uniform(-0.85, 0.85);
    const Vec3 box{random.uniform(0.4, 0.8), random.uniform(0.35, 0.6), random.uniform(0.4, 1.5)};
    const Vec3 spots[] = {
        {along * x, y, 0}, {along * x, -y, 0}, {x, along * y, 0}, {-x, along * y, 0}};
    addBox(scene, spots[i % 4], box, random.uniform(-0.5, 0.5), faces);
  }
}

}  // namespace

World buildRoom(const SyntheticSpec& spec) {
  World world;
  Seeds seeds(mixSeed(spec.seed, 11));
  const Vec3 size(6.4, 6.0, 2.7);
  addShell(world.scene, seeds, size);
  addWallBoxes(world.scene, seeds, size);
  if (spec.preset == "spin") {
    world.motion = spinMotion;
    return world;
  }
  addMiddleBoxes(world.scene, seeds);
  world.motion = roomMotion;
  if (spec.preset == "still") world.motion = [](double) { return roomMotion(0.8); };
  return world;
}

World buildDesk(const SyntheticSpec& spec) {
  World world;
  Scene& scene = world.scene;
  Seeds seeds(mixSeed(spec.seed, 22));
  const cv::Mat wall = pictureWall({5.0, 2.6, 0.0025, seeds()}, 160);
  scene.addQuad({-2.5, 1.1, 2.6}, {5, 0, 0}, {0, 0, -2.6}, scene.addTexture(wall), 0.9f);
  const cv::Mat ground = boards({5.0, 4.0, 0.003, seeds()}, 105, 0.12);
  scene.addQuad({-2.5, 1.1, 0}, {5, 0, 0}, {0, -4, 0}, scene.addTexture(ground), 0.8f);
  for (double side : {-1.0, 1.0}) {
    const cv::Mat beside = pictureWall({4.0, 2.6, 0.0035, seeds()}, 150);
    scene.addQuad({side * 2.5, -2.9, 2.6}, {0, 4, 0}, {0, 0, -2.6}, scene.addTexture(beside), 0.8f);
  }
  addBox(scene, {0, 0.1, 0.70}, {1.9, 1.1, 0.05}, 0, [&](double w, double h) {
    return scene.addTexture(boards({w, h, 0.0015, seeds()}, 145, 0.2));
  });
  const FaceTexture faces = printedFaces(scene, seeds, 0.0012);
  const double top = 0.75;
  addBox(scene, {-0.62, 0.35, top}, {0.45, 0.08, 0.36}, 0.25, faces);  // screens
  addBox(scene, {0.05, 0.42, top}, {0.52, 0.07, 0.34}, -0.05, faces);
  addBox(scene, {0.60, 0.30, top}, {0.20, 0.28, 0.24}, -0.3, faces);    // cartons
  addBox(scene, {0.02, -0.12, top}, {0.44, 0.16, 0.025}, 0.05, faces);  // keyboard
  addBox(scene, {-0.45, -0.15, top}, {0.22, 0.30, 0.05}, 0.4, faces);   // books
  addBox(scene, {-0.44, -0.14, top + 0.05}, {0.18, 0.25, 0.04}, 0.1, faces);
  addBox(scene, {0.40, -0.10, top}, {0.21, 0.297, 0.012}, -0.2, faces);
  addBox(scene, {-0.20, 0.12, top}, {0.08, 0.08, 0.11}, 0.6, faces);  // cup
  addBox(scene, {0.33, 0.18, top}, {0.10, 0.14, 0.09}, 0.9, faces);
  addBox(scene, {0.80, -0.20, top}, {0.16, 0.22, 0.12}, 0.5, faces);
  world.motion = deskMotion;
  return world;
}

World buildCorridor(const SyntheticSpec& spec) {
  World world;
  Scene& scene = world.scene;
  Seeds seeds(mixSeed(spec.seed, 33));
  const double segment = 4.0, half = 1.1, height = 2.6, texel = 0.004;
  const double walked = 1.1 * spec.speed * spec.frames / spec.rate_hz;
  const int segments = static_cast<int>(std::ceil((walked + 12.0) / segment)) + 1;
  const int pool = std::min(segments, 12);  // bounds memory; repeats are 48 m apart
  std::vector<int> left, right, ground, ceiling;
  for (int i = 0; i < pool; ++i) {
    left.push_back(scene.addTexture(corridorWall({segment, height, texel, seeds()})));
    right.push_back(scene.addTexture(corridorWall({segment, height, texel, seeds()})));
    ground.push_back(scene.addTexture(plaster({segment, 2 * half, texel, seeds()}, 125, 0.1)));
    ceiling.push_back(scene.addTexture(corridorCeiling({segment, 2 * half, texel, seeds()})));
  }
  const Vec3 along(segment, 0, 0), down(0, 0, -height);
  for (int i = 0; i < segments; ++i) {
    const double x = (i - 1) * segment;
    scene.addQuad({x, half, height}, along, down, left[i % pool], 1.0f);
    scene.addQuad({x + segment, -half, height}, -along, down, right[i % pool], 0.9f);
    scene.addQuad({x, half, 0}, along, {0, -2 * half, 0}, ground[i % pool], 0.9f);
    scene.addQuad({x, -half, height}, along, {0, 2 * half, 0}, ceiling[i % pool], 0.97f);
  }
  const double end = (segments - 1) * segment;
  const cv::Mat last = corridorWall({2 * half, height, texel, seeds()});
  scene.addQuad({end, half, height}, {0, -2 * half, 0}, down, scene.addTexture(last), 0.8f);
  scene.addQuad({-segment, -half, height}, {0, 2 * half, 0}, down, left[0], 0.8f);
  world.motion = corridorMotion;
  return world;
}

}  // namespace svoscope::synthetic
