// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/plot_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/engine/errors.hpp"
#include "src/io/hdf5_file.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

/// A flow of 3 R outwards and 4 R around the point (0.5, 0.5), which moves on with (7, 0).
class PlotFields : public testing::Test {
 protected:
  PlotFields() : path_(folder_.path() / "gas.hdf5") {
    gas_.dimension = 2;
    std::vector<double> v, matrix;
    for (const double x : {0.1, 0.5, 0.75})
      for (const double y : {0.2, 0.6}) {
        const double d = x - 0.5, e = y - 0.5;
        gas_.x.push_back({x, y, 0});
        v.insert(v.end(), {7 + 3 * d - 4 * e, 4 * d + 3 * e, 0});
        matrix.insert(matrix.end(), {0, 1, 2, 3, 4, 5});
      }
    hdf5::File file = hdf5::File::create();
    hdf5::Group group = file.create_group("PartType0");
    group.write("Velocities", v, 3);
    group.write("V", matrix, 6);
    file.save(path_);
  }

  std::vector<double> values(const std::string& name, const Array3& velocity = {}) const {
    for (const PlotField& field : plot_fields(path_, 2))
      if (field.name == name) return field_values(field, path_, gas_, {{0.5, 0.5, 0}, velocity});
    throw InputError("no field " + name);
  }

  TemporaryFolder folder_;
  std::filesystem::path path_;
  ParticleSet gas_;
};

TEST_F(PlotFields, PartsOfAVectorAboutTheCentreAreBesideItsVelocity) {
  const auto out = values("v_R", {7, 0, 0}), also_out = values("v_r", {7, 0, 0}), around = values("v_phi", {7, 0, 0});
  const auto x = values("v_x", {7, 0, 0}), modulus = values("|v|");
  for (std::size_t i = 0; i < gas_.size(); ++i) {
    const double d = gas_.x[i][0] - 0.5, e = gas_.x[i][1] - 0.5, R = std::hypot(d, e);
    EXPECT_NEAR(out[i], 3 * R, 1e-14);
    EXPECT_NEAR(also_out[i], 3 * R, 1e-14);
    EXPECT_NEAR(around[i], 4 * R, 1e-14);
    EXPECT_DOUBLE_EQ(x[i], 7 + 3 * d - 4 * e) << "components along axes are as they are";
    EXPECT_NEAR(modulus[i], std::hypot(7 + 3 * d - 4 * e, 4 * d + 3 * e), 1e-14);
  }
}

TEST_F(PlotFields, TheNearestImageCounts) {
  gas_.box.periodic = {true, false, false};
  EXPECT_NEAR(offset({0.9, 0.9, 5}, {0.1, 0.1, 0}, gas_)[0], -0.2, 1e-15);
  EXPECT_NEAR(offset({0.9, 0.9, 5}, {0.1, 0.1, 0}, gas_)[1], 0.8, 1e-15);
  EXPECT_EQ(offset({0.9, 0.9, 5}, {0.1, 0.1, 0}, gas_)[2], 0) << "gas in 2D";
}

TEST_F(PlotFields, PartsOfAMatrixStandBehindItsDiagonal) {
  EXPECT_EQ(values("V_yy"), std::vector<double>(gas_.size(), 1));
  EXPECT_EQ(values("V_xy"), std::vector<double>(gas_.size(), 3));
  EXPECT_THROW(values("V_xz"), InputError) << "gas in 2D";
}

}  // namespace
}  // namespace sphk
