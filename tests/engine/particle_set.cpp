// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/particle_set.hpp"

#include <gtest/gtest.h>

#include "src/schemes/registry.hpp"

namespace sphk {
namespace {

TEST(ParticleSet, TagsAreSortedById) {
  ParticleSet gas;
  gas.id = {7, 2, 5};
  gas.tag = {70, 20, 50};
  EXPECT_EQ(phase_tags(gas).values, (std::vector<double>{20, 50, 70}));
  gas.id.clear();
  EXPECT_EQ(phase_tags(gas).values, (std::vector<double>{70, 20, 50}));
  gas.tag.clear();
  EXPECT_TRUE(phase_tags(gas).values.empty());
}

/// Even gas at rest whose ids count down and whose tags tell the half of the box.
ParticleSet tagged_gas() {
  ParticleSet gas;
  gas.dimension = 2;
  gas.box.periodic = {true, true, false};
  constexpr int n = 12;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      gas.x.push_back({(i + 0.5) / n, (j + 0.5) / n, 0});
      gas.tag.push_back(i < n / 2 ? 0 : 1);
      gas.id.push_back(1000 - gas.x.size());
    }
  gas.v.assign(gas.size(), {});
  gas.m.assign(gas.size(), 1.0 / (n * n));
  gas.u.assign(gas.size(), 1);
  return gas;
}

// The engine sorts particles along a curve; a tag stays with its particle.
TEST(ParticleSet, TagsFollowTheirParticlesThroughTheEngine) {
  const auto run = make_simulation(tagged_gas(), {.scheme = "gadget2", .kernel = "cs", .neighbours = 20});
  run->step(1e-3);
  const Snapshot snapshot = run->snapshot();
  const auto &x = snapshot.field("Coordinates").values, &tags = snapshot.field("PhaseTags").values;
  ASSERT_EQ(tags.size(), snapshot.size());
  for (std::size_t i = 0; i < tags.size(); ++i) EXPECT_EQ(tags[i], x[3 * i] < 0.5 ? 0 : 1);
}

/// A view's fields have their values when they are asked for, those of a snapshot, and again after they were let go of.
TEST(ParticleSet, AViewMakesItsFieldsWhenTheyAreAskedFor) {
  const auto run = make_simulation(tagged_gas(), {.scheme = "gadget2", .kernel = "cs", .neighbours = 20});
  const Snapshot snapshot = run->snapshot(), view = run->view();
  EXPECT_EQ(view.id, snapshot.id);
  ASSERT_EQ(view.fields.size(), snapshot.fields.size());
  for (int round = 0; round < 2; ++round) {
    for (const Field& field : view.fields) EXPECT_TRUE(field.values.empty()) << field.name;
    for (const Field& field : snapshot.fields) {
      EXPECT_FALSE(field.values.empty()) << field.name;
      EXPECT_EQ(view.field(field.name).values, field.values) << field.name;
    }
    view.let_go();
  }
}

TEST(ParticleSet, WithoutTagsThereIsNoSuchField) {
  ParticleSet gas = tagged_gas();
  gas.tag.clear();
  const auto run = make_simulation(gas, {.scheme = "gadget2", .kernel = "cs", .neighbours = 20});
  EXPECT_FALSE(run->snapshot().has("PhaseTags"));
}

}  // namespace
}  // namespace sphk
