#include "optimize/pose_graph.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace glide {
namespace {

// Cameras once around a circle of this radius.
constexpr double kRadius = 10.0;
constexpr double kTurn = 6.283185307179586;

double distance(const Sim3d& a, const Sim3d& b) { return (a * b.inverse()).log().norm(); }

/// Camera `i` of `count` around a circle, looking along it.
Sim3d onCircle(int i, int count) {
  const double angle = kTurn * i / count;
  const Sim3d S_world_cam{
      so3Exp(Vec3d(0.0, -angle, 0.0)), kRadius * Vec3d(std::cos(angle), 0.0, std::sin(angle)), 1.0};
  return S_world_cam.inverse();
}

/// A loop around the circle: odometry between neighbours that drifts by `drift` in each step, poses
/// as odometry has them, and the true edge from the last camera to the first.
struct Loop {
  std::vector<Sim3d> truth;
  PoseGraph graph;
};

Loop driftingLoop(int count, const Vec7d& drift) {
  Loop loop;
  loop.graph.vertices.push_back({onCircle(0, count), true});
  loop.truth.push_back(onCircle(0, count));
  for (int i = 1; i < count; ++i) {
    loop.truth.push_back(onCircle(i, count));
    const Sim3d S_step = onCircle(i - 1, count) * onCircle(i, count).inverse() * Sim3d::exp(drift);
    loop.graph.vertices.push_back({S_step.inverse() * loop.graph.vertices.back().S_cam_world});
    loop.graph.edges.push_back({i - 1, i, S_step});
  }
  const Sim3d S_last_first = loop.truth.back() * loop.truth.front().inverse();
  loop.graph.edges.push_back({count - 1, 0, S_last_first});
  return loop;
}

Vec7d scaleDrift(double log_scale) { return log_scale * Vec7d::Unit(6); }

double worstCenterError(const Loop& loop) {
  double worst = 0.0;
  for (std::size_t i = 0; i < loop.truth.size(); ++i) {
    const Vec3d center = loop.graph.vertices[i].S_cam_world.inverse().t;
    worst = std::max(worst, (center - loop.truth[i].inverse().t).norm());
  }
  return worst;
}

TEST(PoseGraphTest, RecoversTheTruthOfExactEdges) {
  Loop loop = driftingLoop(12, Vec7d::Zero());
  for (std::size_t i = 1; i < loop.graph.vertices.size(); ++i) {
    const Vec7d off = 0.3 * Vec7d::Unit(int(i % 7)) - 0.2 * Vec7d::Unit(int(i % 5));
    loop.graph.vertices[i].S_cam_world = Sim3d::exp(off) * loop.graph.vertices[i].S_cam_world;
  }
  const PoseGraphSummary summary = solvePoseGraph({}, &loop.graph);
  EXPECT_TRUE(summary.usable);
  EXPECT_GT(summary.initial_cost, 0.1);
  EXPECT_LT(summary.final_cost, 1e-12);
  for (std::size_t i = 0; i < loop.truth.size(); ++i) {
    EXPECT_LT(distance(loop.graph.vertices[i].S_cam_world, loop.truth[i]), 1e-5);
  }
}

TEST(PoseGraphTest, SpreadsTheScaleDriftOfALoopOverItsCameras) {
  const int count = 60;
  Loop loop = driftingLoop(count, scaleDrift(0.005));  // 34 % in the end
  const double before = worstCenterError(loop);
  const PoseGraphSummary summary = solvePoseGraph({}, &loop.graph);
  ASSERT_TRUE(summary.usable);
  EXPECT_LT(worstCenterError(loop), 0.1 * before);
  // The 60th part of the drift is left in each edge.
  const double log_scale = std::log(loop.graph.vertices.back().S_cam_world.s);
  EXPECT_NEAR(log_scale, 0.0, 0.01);
}

TEST(PoseGraphTest, ClosesALoopThatAlsoTurnsAndShifts) {
  const Vec7d drift = (Vec7d() << 0.01, 0.005, -0.01, 0.002, 0.003, -0.001, -0.004).finished();
  Loop loop = driftingLoop(100, drift);
  const double before = worstCenterError(loop);
  ASSERT_TRUE(solvePoseGraph({}, &loop.graph).usable);
  EXPECT_LT(worstCenterError(loop), before / 3.0);
  const Sim3d S_last_first =
      loop.graph.vertices.back().S_cam_world * loop.graph.vertices.front().S_cam_world.inverse();
  EXPECT_LT(distance(S_last_first, loop.graph.edges.back().S_a_b), 0.05);
}

TEST(PoseGraphTest, ClosesALongLoopWhoseScaleHasDoubled) {
  Loop loop = driftingLoop(700, scaleDrift(0.001));
  for (PoseGraph::Edge& edge : loop.graph.edges) edge.S_a_b.t *= 30.0;
  for (Sim3d& S_cam_world : loop.truth) S_cam_world.t *= 30.0;
  for (PoseGraph::Vertex& vertex : loop.graph.vertices) vertex.S_cam_world.t *= 30.0;
  const double before = worstCenterError(loop);
  const PoseGraphSummary summary = solvePoseGraph({}, &loop.graph);
  EXPECT_TRUE(summary.usable);
  EXPECT_LT(worstCenterError(loop), 0.2 * before);
}

TEST(PoseGraphTest, BelievesAHeavyEdgeMoreThanALightOne) {
  for (const double weight : {1e-3, 1e3}) {
    PoseGraph graph;
    graph.vertices = {{Sim3d{}, true}, {Sim3d{}}};
    graph.edges = {{0, 1, Sim3d{}}, {0, 1, Sim3d::exp(scaleDrift(0.2)), weight}};
    ASSERT_TRUE(solvePoseGraph({}, &graph).usable);
    const double log_scale = std::log(graph.vertices[1].S_cam_world.s);
    EXPECT_NEAR(log_scale, -0.2 * weight / (1.0 + weight), 1e-6);
  }
}

TEST(PoseGraphTest, LeavesFixedAndUnconnectedCamerasWhereTheyAre) {
  Loop loop = driftingLoop(20, scaleDrift(0.01));
  loop.graph.vertices[7].fixed = true;
  loop.graph.vertices.push_back({Sim3d::exp(Vec7d::Constant(0.3))});
  const PoseGraph before = loop.graph;
  ASSERT_TRUE(solvePoseGraph({}, &loop.graph).usable);
  for (const std::size_t i : {std::size_t{0}, std::size_t{7}, loop.graph.vertices.size() - 1}) {
    EXPECT_EQ(loop.graph.vertices[i].S_cam_world.t, before.vertices[i].S_cam_world.t);
    EXPECT_EQ(loop.graph.vertices[i].S_cam_world.s, before.vertices[i].S_cam_world.s);
  }
  EXPECT_GT(distance(loop.graph.vertices[10].S_cam_world, before.vertices[10].S_cam_world), 1e-3);
}

TEST(PoseGraphTest, ChangesNothingWhenCancelled) {
  const std::atomic<bool> cancel{true};
  Loop loop = driftingLoop(20, scaleDrift(0.01));
  const Sim3d before = loop.graph.vertices[10].S_cam_world;
  const PoseGraphSummary summary = solvePoseGraph({.cancel = &cancel}, &loop.graph);
  EXPECT_TRUE(summary.cancelled);
  EXPECT_FALSE(summary.usable);
  EXPECT_EQ(loop.graph.vertices[10].S_cam_world.t, before.t);
}

TEST(PoseGraphTest, IsOfNoUseWithoutAnythingToMove) {
  PoseGraph empty;
  EXPECT_FALSE(solvePoseGraph({}, &empty).usable);
  PoseGraph fixed;
  fixed.vertices = {{Sim3d{}, true}, {Sim3d{}, true}};
  fixed.edges = {{0, 1, Sim3d::exp(scaleDrift(0.1))}};
  EXPECT_FALSE(solvePoseGraph({}, &fixed).usable);
}

TEST(PoseGraphTest, GivesTheSameBitsTwice) {
  Loop first = driftingLoop(40, scaleDrift(0.01));
  Loop second = first;
  solvePoseGraph({}, &first.graph);
  solvePoseGraph({}, &second.graph);
  for (std::size_t i = 0; i < first.graph.vertices.size(); ++i) {
    const Sim3d& a = first.graph.vertices[i].S_cam_world;
    const Sim3d& b = second.graph.vertices[i].S_cam_world;
    EXPECT_TRUE(a.q.coeffs() == b.q.coeffs() && a.t == b.t && a.s == b.s);
  }
}

TEST(KeyframeMoves, CarryWhatACameraSees) {
  Loop loop = driftingLoop(20, scaleDrift(0.01));
  const PoseGraph before = loop.graph;
  ASSERT_TRUE(solvePoseGraph({}, &loop.graph).usable);
  std::vector<KeyframeId> ids;
  for (std::size_t i = 0; i < before.vertices.size(); ++i) ids.push_back(KeyframeId{3 * i});
  const std::vector<KeyframeMove> moves = keyframeMoves(ids, before, loop.graph);
  ASSERT_EQ(moves.size(), ids.size());
  EXPECT_LT(moves[0].S_new_old.log().norm(), 1e-15);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    EXPECT_EQ(moves[i].id, ids[i]);
    const Vec3d p_cam(0.3, -0.4, 5.0);
    const Vec3d p_old = before.vertices[i].S_cam_world.inverse() * p_cam;
    const Vec3d p_new = loop.graph.vertices[i].S_cam_world.inverse() * p_cam;
    EXPECT_LT((moves[i].S_new_old * p_old - p_new).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace glide
