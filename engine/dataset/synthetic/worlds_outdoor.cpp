// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "engine/dataset/synthetic/motion.h"
#include "engine/dataset/synthetic/patterns.h"
#include "engine/dataset/synthetic/random.h"
#include "engine/dataset/synthetic/world.h"

namespace svoscope::synthetic {
namespace {

const double kHouse = 12.0;      ///< m, width of a house
const double kFacade = 8.5;      ///< m, from the middle of the street
const double kKerb = 5.5;        ///< m
const double kRoadPiece = 24.0;  ///< m
const double kSeen = 160.0;      ///< m of street ahead of the last frame

/// Textures that repeat far apart only: bounds memory on long drives.
template <typename Make>
std::vector<int> texturePool(Scene& scene, int count, Make make) {
  std::vector<int> pool;
  for (int i = 0; i < count; ++i) pool.push_back(scene.addTexture(make(i)));
  return pool;
}

void addHouses(Scene& scene, std::uint64_t seed, double from, double to) {
  const int needed = static_cast<int>(std::ceil((to - from) / kHouse));
  const auto houseHeight = [&](int i) { return Random(mixSeed(seed, 50 + i)).uniform(8, 13); };
  const int pool_size = std::min(2 * needed, 26);
  const auto pool = texturePool(scene, pool_size, [&](int i) {
    return facade({kHouse, houseHeight(i), 0.0125 * scene.texel_scale, mixSeed(seed, 100 + i)});
  });
  for (int i = 0; i < needed; ++i) {
    for (int side : {-1, 1}) {
      const int kind = (2 * i + (side > 0)) % pool_size;
      const double z = houseHeight(kind), x = from + i * kHouse;
      // Houses stand back by different amounts: depth changes from one to the next.
      const double y =
          side * (kFacade + Random(mixSeed(seed, 900 + 2 * i + (side > 0))).uniform(0, 1.2));
      const Vec3 left(side > 0 ? x : x + kHouse, y, z);
      scene.addQuad(left, {side * kHouse, 0, 0}, {0, 0, -z}, pool[kind], side > 0 ? 1.0f : 0.82f);
      // The gable, where a house stands in front of its neighbour.
      scene.addQuad({x, y + side * 3.0, z}, {0, -side * 3.0, 0}, {0, 0, -z}, pool[kind], 0.65f);
    }
  }
}

void addGround(Scene& scene, std::uint64_t seed, double from, double to) {
  const int pieces = static_cast<int>(std::ceil((to - from) / kRoadPiece));
  const int pool_size = std::min(pieces, 6);
  const auto road = texturePool(scene, pool_size, [&](int i) {
    return asphalt({kRoadPiece, 2 * kKerb, 0.01 * scene.texel_scale, mixSeed(seed, 200 + i)}, true);
  });
  const double pavement = kFacade + 4.5 - kKerb;
  const auto walk = texturePool(scene, pool_size, [&](int i) {
    return stoneFloor({kRoadPiece, pavement, 0.012 * scene.texel_scale, mixSeed(seed, 300 + i)},
                      130, 0.5);
  });
  for (int i = 0; i < pieces; ++i) {
    const double x = from + i * kRoadPiece;
    const Vec3 along(kRoadPiece, 0, 0);
    scene.addQuad({x, kKerb, 0}, along, {0, -2 * kKerb, 0}, road[i % pool_size]);
    scene.addQuad({x, kKerb + pavement, 0.0}, along, {0, -pavement, 0}, walk[i % pool_size]);
    scene.addQuad({x, -kKerb, 0.0}, along, {0, -pavement, 0}, walk[(i + 2) % pool_size], 0.85f);
  }
}

/// Parked vans and crates along both kerbs.
void addParked(Scene& scene, std::uint64_t seed, double from, double to) {
  Random random(mixSeed(seed, 400));
  const int kKinds = 12;
  const auto pool = texturePool(scene, kKinds, [&](int i) {
    Random shade(mixSeed(seed, 500 + i));
    const Surface surface{4.0, 1.6, 0.01 * scene.texel_scale, mixSeed(seed, 600 + i)};
    return shapes(surface, shade.uniform(70, 180), 75, 0.7);
  });
  for (double x = from; x < to; x += random.uniform(6.5, 14)) {
    const int side = random.below(2) ? 1 : -1;
    const Vec3 size{random.uniform(2.5, 4.6), random.uniform(1.5, 1.9), random.uniform(1.2, 2.1)};
    addBox(scene, {x, side * (kKerb - 1.2), 0}, size, random.uniform(-0.04, 0.04),
           [&](double, double) { return pool[random.below(kKinds)]; });
  }
}

}  // namespace

World::World(const SyntheticSpec& spec, double width, double focal_px)
    : focal(focal_px), preset_width(width) {
  scene.texel_scale = std::clamp(width / spec.width, 1.0, 4.0);
  scene.contrast = spec.texture;
}

World buildStreet(const SyntheticSpec& spec) {
  World world(spec, 640, 525);
  world.scene.sky = 225;
  const std::uint64_t seed = mixSeed(spec.seed, 44);
  const double from = -12.0, to = 8.0 * spec.speed * spec.frames / spec.rate_hz + kSeen;
  addGround(world.scene, seed, from, to);
  addHouses(world.scene, seed, from, to);
  addParked(world.scene, seed, from + 20.0, to);
  const cv::Mat end = facade({40.0, 14.0, 0.04, mixSeed(seed, 700)});
  world.scene.addQuad({to, 20, 14}, {0, -40, 0}, {0, 0, -14}, world.scene.addTexture(end), 0.9f);
  world.motion = streetMotion;
  return world;
}

World buildFloor(const SyntheticSpec& spec) {
  World world(spec, 752, 315);
  Scene& scene = world.scene;
  const std::uint64_t seed = mixSeed(spec.seed, 55);
  const double x = 8.0, y = 6.5;
  const cv::Mat ground =
      stoneFloor({2 * x, 2 * y, 0.005 * scene.texel_scale, mixSeed(seed, 1)}, 120, 0.8);
  scene.addQuad({-x, y, 0}, {2 * x, 0, 0}, {0, -2 * y, 0}, scene.addTexture(ground));
  Random random(mixSeed(seed, 2));
  for (int i = 0; i < 14; ++i) {
    const Vec3 place{random.uniform(-5, 5), random.uniform(-3.8, 3.8), 0};
    const Vec3 size{random.uniform(0.3, 0.8), random.uniform(0.3, 0.8), random.uniform(0.08, 0.4)};
    addBox(scene, place, size, random.uniform(0, 3), [&](double w, double h) {
      const Surface surface{w, h, 0.004 * scene.texel_scale, random.next()};
      return scene.addTexture(shapes(surface, random.uniform(80, 180), 80, 0.2));
    });
  }
  world.motion = floorMotion;
  return world;
}

namespace {

World buildScene(const SyntheticSpec& spec) {
  if (spec.preset == "desk") return buildDesk(spec);
  if (spec.preset == "floor") return buildFloor(spec);
  if (spec.preset == "corridor") return buildCorridor(spec);
  if (spec.preset == "forward") return buildStreet(spec);
  return buildRoom(spec);
}

}  // namespace

World buildWorld(const SyntheticSpec& spec) {
  World world = buildScene(spec);
  world.movers = buildMovers(spec, world.scene);
  return world;
}

}  // namespace svoscope::synthetic
