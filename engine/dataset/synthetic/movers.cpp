// SPDX-License-Identifier: MIT
#include "engine/dataset/synthetic/movers.h"

#include <algorithm>
#include <cmath>

#include "engine/dataset/synthetic/patterns.h"
#include "engine/dataset/synthetic/random.h"

namespace svoscope::synthetic {
namespace {

/// Place on the ground and heading, the own x axis pointing along the heading.
SE3 standing(double x, double y, double z, double heading) {
  return SE3(Eigen::Quaterniond(Eigen::AngleAxisd(heading, Vec3::UnitZ())), Vec3(x, y, z));
}

/// A sine whose amplitude, frequency and phase differ from mover to mover.
struct Swing {
  double centre, amplitude, rate, phase;
  double at(double t) const { return centre + amplitude * std::sin(rate * t + phase); }
};

struct Plan {
  Vec3 size;  ///< m
  std::function<SE3(double)> motion;
};

/// To and fro between the camera and the things in the middle.
Plan roomPlan(int index, Random& random) {
  const Swing x{random.uniform(-0.2, 0.2), random.uniform(0.7, 1.0), random.uniform(0.5, 0.9),
                2.4 * index + random.uniform(0, 0.8)};
  const Swing y{-0.35 + 0.35 * (index % 4), 0.2, random.uniform(0.3, 0.6), random.uniform(0, 6)};
  const double turn = random.uniform(0.3, 0.6), height = random.uniform(0.9, 1.5);
  return {{random.uniform(0.28, 0.4), random.uniform(0.25, 0.35), height},
          [=](double t) { return standing(x.at(t), y.at(t), 0, turn * t); }};
}

/// Around the camera, which stands in the middle of the room.
Plan spinPlan(int index, Random& random) {
  const double radius = random.uniform(1.5, 2.2), rate = random.uniform(0.15, 0.45);
  const double start = 1.1 + 2.1 * index, sign = index % 2 ? -1 : 1;
  return {{random.uniform(0.35, 0.5), random.uniform(0.3, 0.4), random.uniform(1.3, 1.8)},
          [=](double t) {
            const double a = start + sign * rate * t;
            return standing(radius * std::cos(a), radius * std::sin(a), 0, a);
          }};
}

Plan deskPlan(int index, Random& random) {
  const Swing x{random.uniform(-0.15, 0.15), random.uniform(0.3, 0.55), random.uniform(0.5, 1.0),
                1.9 * index + random.uniform(0, 0.8)};
  const Swing y{-0.3 + 0.16 * (index % 4), 0.05, random.uniform(0.4, 0.8), random.uniform(0, 6)};
  const double turn = random.uniform(-0.5, 0.5);
  return {{random.uniform(0.14, 0.24), random.uniform(0.1, 0.18), random.uniform(0.1, 0.26)},
          [=](double t) { return standing(x.at(t), y.at(t), 0.75, turn * t); }};
}

Plan floorPlan(int index, Random& random) {
  const Swing x{0, random.uniform(1.5, 3.2), random.uniform(0.3, 0.55),
                1.3 * index + random.uniform(0, 0.8)};
  const Swing y{0, random.uniform(1.2, 2.4), random.uniform(0.35, 0.6), random.uniform(0, 6)};
  return {{random.uniform(0.6, 0.9), random.uniform(0.4, 0.6), random.uniform(0.2, 0.45)},
          [=](double t) { return standing(x.at(t), y.at(t), 0, 0.3 * t + index); }};
}

/// `x` brought into the window [from, from + length) by whole lengths: who falls behind the camera
/// comes again in the distance.
double wrapped(double x, double from, double length) {
  return from + (x - from) - length * std::floor((x - from) / length);
}

/// People: some walk ahead, some come towards the camera, at the sides it does not use.
Plan corridorPlan(int index, Random& random, double camera_speed) {
  const double side = index % 2 ? 0.72 : -0.72;
  const double speed =
      index % 2 ? -random.uniform(0.7, 1.2) : camera_speed * random.uniform(0.9, 1);
  const double start = 2.5 + 2.3 * index;
  return {{0.3, 0.4, random.uniform(1.6, 1.85)}, [=](double t) {
            const double x = wrapped(start + speed * t, camera_speed * t + 0.5, 14);
            return standing(x, side, 0, 0);
          }};
}

/// Vehicles: some drive ahead in the same lane, some come towards the camera.
Plan streetPlan(int index, Random& random, double camera_speed) {
  const bool ahead = index % 2 == 0;
  const Swing gap{9.0 + 9.0 * (index / 2), 2.0, 0.5, random.uniform(0, 6)};
  const double oncoming = random.uniform(6, 9), start = 25 + 14.0 * index;
  return {{random.uniform(3.8, 4.6), 1.7, random.uniform(1.45, 2.2)}, [=](double t) {
            const double camera = camera_speed * t;
            if (ahead) return standing(camera + gap.at(t), -0.3, 0, 0);
            return standing(wrapped(start - oncoming * t, camera - 3, 110), 2.3, 0, 0);
          }};
}

Plan planFor(const SyntheticSpec& spec, int index, Random& random) {
  if (spec.preset == "spin") return spinPlan(index, random);
  if (spec.preset == "desk") return deskPlan(index, random);
  if (spec.preset == "floor") return floorPlan(index, random);
  if (spec.preset == "corridor") return corridorPlan(index, random, 1.1 * spec.speed);
  if (spec.preset == "forward") return streetPlan(index, random, 8.0 * spec.speed);
  return roomPlan(index, random);
}

}  // namespace

std::vector<Mover> buildMovers(const SyntheticSpec& spec, Scene& scene) {
  std::vector<Mover> movers;
  for (int i = 0; i < spec.movers; ++i) {
    Random random(mixSeed(mixSeed(spec.seed, 66), i));
    Plan plan = planFor(spec, i, random);
    Scene box;  // only its quads are used: the textures belong to the scene
    addBox(box, Vec3::Zero(), plan.size, 0, [&](double width, double height) {
      const double texel = std::max(0.0012, std::max(width, height) / 600) * scene.texel_scale;
      const Surface surface{width, height, texel, random.next()};
      const double largest = 0.35 * std::min(width, height);
      return scene.addTexture(shapes(surface, random.uniform(80, 175), 75, largest));
    });
    movers.push_back({std::move(box.quads), std::move(plan.motion)});
  }
  return movers;
}

}  // namespace svoscope::synthetic
