// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/layouts.hpp"

#include "src/io/reader.hpp"
#include "tests/io/example.hpp"

namespace sphk {
namespace {

using Change = std::function<void(hdf5::File&)>;

/// A change that sets an attribute of a group, which is made where it is missing.
template <class T>
Change with(const char* group, const char* name, T value) {
  return [=](hdf5::File& made) {
    hdf5::Group holder = made.has(group) ? made.group(group) : made.create_group(group);
    holder.set(name, value);
  };
}

class Layouts : public Scratch {
 protected:
  /// The example, of three columns and a BoxSize of 2, with changes.
  ReadResult read(const std::vector<Change>& changes) const {
    hdf5::File made = ExampleIc{}.make();
    for (const Change& change : changes) change(made);
    made.save(file("ic.hdf5"));
    return read_particles(file("ic.hdf5"));
  }
  std::string error_of(const std::vector<Change>& changes) const {
    return input_error([&] { read(changes); });
  }
  bool is_periodic(const std::vector<Change>& changes) const { return read(changes).particles.box.periodic[0]; }
};

TEST_F(Layouts, OpenAndPeriodicBoxes) {
  EXPECT_FALSE(is_periodic({with("RuntimePars", "PeriodicBoundariesOn", 0)}));
  EXPECT_TRUE(is_periodic({with("RuntimePars", "PeriodicBoundariesOn", 1)}));
  EXPECT_FALSE(is_periodic({with("Parameters", "InitialConditions:periodic", "0")}));
  EXPECT_TRUE(is_periodic({with("Parameters", "InitialConditions:periodic", "1")}));
  EXPECT_FALSE(is_periodic({with("Parameters", "PeriodicBoundariesOn", 0)}));
  EXPECT_FALSE(is_periodic({with("Header", "PeriodicBoundariesOn", 0)}));
  EXPECT_TRUE(is_periodic({with("Config", "PERIODIC", "")}));
  EXPECT_FALSE(is_periodic({with("Config", "NTYPES", 6.0)}));
  EXPECT_TRUE(mentions(
      error_of({with("RuntimePars", "PeriodicBoundariesOn", 1), with("Parameters", "InitialConditions:periodic", "0")}),
      {"RuntimePars", "InitialConditions:periodic", "different things"}));
}

TEST_F(Layouts, ComovingFilesAreRefused) {
  for (const auto& [group, name] :
       {std::pair{"Cosmology", "Cosmological run"}, std::pair{"Policy", "cosmological integration"},
        std::pair{"Parameters", "ComovingIntegrationOn"}, std::pair{"Header", "ComovingIntegrationOn"}})
    EXPECT_TRUE(mentions(error_of({with(group, name, 1)}), {"ic.hdf5", name, group, "comoving", "set it to 0"}));
  EXPECT_TRUE(mentions(error_of({with("Header", "Redshift", 2.0), with("Header", "Omega0", 0.3)}),
                       {"Redshift", "is 2", "comoving"}));
  EXPECT_TRUE(mentions(error_of({with("Header", "Scale-factor", 0.5)}), {"Scale-factor", "comoving"}));
  const Change now = with("Header", "Time", 1.0), matter = with("Header", "Omega0", 0.3);
  EXPECT_TRUE(mentions(error_of({now, matter}), {"0.3", "scale factor", "Omega0"}));
}

TEST_F(Layouts, PhysicalFilesAreNot) {
  EXPECT_EQ(read({with("Header", "Time", 1.0), with("Header", "Omega0", 0.0)}).particles.size(), 8);
  EXPECT_EQ(read({with("Header", "Time", 0.5), with("Header", "Omega0", 0.3)}).particles.size(), 8);
  EXPECT_EQ(
      read({with("Header", "Time", 1.0), with("Header", "Omega0", 0.3), with("Parameters", "ComovingIntegrationOn", 0)})
          .particles.size(),
      8);
}

TEST_F(Layouts, DimensionsThatAreSaid) {
  const auto dimension = [&](const Change& change) { return read({change}).particles.dimension; };
  EXPECT_EQ(dimension(with("Header", "Dimension", 1)), 1);
  EXPECT_EQ(dimension(with("HydroScheme", "Dimension", 2)), 2);
  EXPECT_EQ(dimension(with("Config", "ONEDIMS", "")), 1);
  EXPECT_EQ(dimension(with("Config", "TWODIMS", "")), 2);
  EXPECT_EQ(dimension(with("Header", "BOX_SPATIAL_DIMENSION", 2)), 2);
  EXPECT_TRUE(read({with("Config", "NTYPES", 6.0)}).dimension_said) << "three, without an option";
  EXPECT_FALSE(read({}).dimension_said);
}

TEST_F(Layouts, AdiabaticIndices) {
  EXPECT_EQ(read({with("HydroScheme", "Adiabatic index", 1.4)}).gamma, 1.4);
  EXPECT_EQ(read({with("Config", "GAMMA", 1.25)}).gamma, 1.25);
  EXPECT_EQ(read({with("Config", "NTYPES", 6.0)}).gamma, 5.0 / 3) << "of GADGET-4 without the option";
  EXPECT_FALSE(read({with("Config", "ISOTHERM_EQS", "")}).gamma);
  EXPECT_FALSE(read({}).gamma);
}

TEST_F(Layouts, Units) {
  const auto expect_units = [](const ReadResult& result) {
    ASSERT_TRUE(result.units);
    EXPECT_EQ(result.units->length, 8);
    EXPECT_EQ(result.units->mass, 3);
    EXPECT_EQ(result.units->time, 4);
  };
  expect_units(read({with("Units", "Unit length in cgs (U_L)", 8.0), with("Units", "Unit mass in cgs (U_M)", 3.0),
                     with("Units", "Unit time in cgs (U_t)", 4.0)}));
  expect_units(read({with("Parameters", "UnitLength_in_cm", 8.0), with("Parameters", "UnitMass_in_g", 3.0),
                     with("Parameters", "UnitVelocity_in_cm_per_s", 2.0)}));
  expect_units(read({with("Header", "UnitLength_In_CGS", 8.0), with("Header", "UnitMass_In_CGS", 3.0),
                     with("Header", "UnitVelocity_In_CGS", 2.0)}));
  EXPECT_FALSE(read({}).units);
  for (const double wrong : {0.0, -1.0})
    EXPECT_TRUE(mentions(error_of({with("Units", "Unit time in cgs (U_t)", wrong)}), {"Units", "U_t", "positive"}));
  EXPECT_TRUE(mentions(error_of({with("Units", "Unit length in cgs (U_L)", "kpc")}), {"U_L", "\"kpc\"", "a number"}));
}

TEST_F(Layouts, StretchedBoxesAndWalls) {
  const ParticleSet p =
      read({with("Config", "PERIODIC", ""), with("Config", "LONG_Y", 3.0), with("Config", "LONG_Z_BITS", 2.0)})
          .particles;
  EXPECT_EQ(p.box.size, (Array3{2, 6, 0.5}));
  EXPECT_TRUE(mentions(error_of({with("Config", "REFLECTIVE_X", 2.0)}), {"REFLECTIVE_X", "walls"}));
}

// A leftover size of an open box would bound the search for neighbours. Here it is 2/8, and 0.
TEST_F(Layouts, OpenBoxesHoldAllParticles) {
  const Change open = with("Header", "PeriodicBoundariesOn", 0), periodic = with("Header", "PeriodicBoundariesOn", 1);
  const ParticleSet p = read({open, with("Config", "LONG_X", 0.125)}).particles;
  EXPECT_EQ(p.box.lower, (Array3{0, 0, 0}));
  EXPECT_EQ(p.box.size, (Array3{21.0 / 64, 2, 2}));  // x of the last of 8 rows, as ExampleIc has them
  EXPECT_TRUE(mentions(error_of({periodic, with("Config", "LONG_X", 0.0)}), {"periodic", "no BoxSize along x"}));
}

TEST_F(Layouts, CountsOfTheHeaderAreThoseOfTheDatasets) {
  const auto total = [](std::uint32_t low) {
    return with("Header", "NumPart_Total", std::vector<std::uint32_t>{low, 0, 0, 0, 0, 0});
  };
  EXPECT_EQ(read({total(8)}).particles.size(), 8);
  EXPECT_TRUE(mentions(error_of({total(9)}), {"NumPart_Total says 9", "has 8"}));
  const Change high = with("Header", "NumPart_Total_HighWord", std::vector<std::uint32_t>{1, 0, 0, 0, 0, 0});
  EXPECT_TRUE(mentions(error_of({total(8), high}), {"4294967304", "more than sphk can count, 2147483647"}));
}

}  // namespace
}  // namespace sphk
