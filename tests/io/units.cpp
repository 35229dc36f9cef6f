// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/units.hpp"

#include <numbers>

#include "src/io/reader.hpp"
#include "tests/io/example.hpp"

namespace sphk {
namespace {

constexpr double kpc = 1e3 * 648000 / std::numbers::pi * 149597870700e2;  // IAU 2012, 2015: exact
constexpr double Msun = 1.3271244e26 / 6.67430e-8;                        // GM of IAU 2015 over G of CODATA 2018
constexpr double Gyr = 1e9 * 365.25 * 24 * 3600;

TEST(Units, NamesNumbersAndBoth) {
  EXPECT_DOUBLE_EQ(unit_in_cgs(UnitOf::length, "kpc"), kpc);
  EXPECT_DOUBLE_EQ(unit_in_cgs(UnitOf::length, " 10 kpc "), 10 * kpc);
  EXPECT_DOUBLE_EQ(unit_in_cgs(UnitOf::length, "3.5e21"), 3.5e21);
  EXPECT_NEAR(unit_in_cgs(UnitOf::mass, "1e10 Msun") / (1e10 * Msun), 1, 1e-5) << "G is known to five digits";
  EXPECT_EQ(unit_in_cgs(UnitOf::mass, "1e10Msun"), unit_in_cgs(UnitOf::mass, "1e10 Msun"));
  EXPECT_DOUBLE_EQ(unit_in_cgs(UnitOf::time, "Gyr"), Gyr);
  EXPECT_DOUBLE_EQ(unit_in_cgs(UnitOf::velocity, "km/s"), 1e5);
  EXPECT_DOUBLE_EQ(unit_in_cgs(UnitOf::velocity, "2 pc / Myr"), 2 * (kpc / 1e3) / (Gyr / 1e3));
}

TEST(Units, NonsenseIsRefusedWithTheNames) {
  for (const char* text :
       {"", "0", "-1", "nan", "inf", "0 kpc", "-kpc", "1e400", "kpc kpc", "Kpc", "Msun", "1e999 kpc"})
    EXPECT_TRUE(mentions(input_error([&] { unit_in_cgs(UnitOf::length, text); }),
                         {'"' + std::string(text) + '"', "no unit of length", "kpc", "in cgs"}));
  EXPECT_TRUE(mentions(input_error([] { unit_in_cgs(UnitOf::velocity, "kpc"); }), {"no unit of velocity", "km/s"}));
  EXPECT_TRUE(mentions(input_error([] { unit_in_cgs(UnitOf::mass, "1e70"); }), {"1e70", "between 1e-60 and 1e+60"}));
}

TEST(Units, ANameIsFoundByItsValue) {
  EXPECT_EQ(unit_name(UnitOf::length, kpc), "kpc");
  EXPECT_EQ(unit_name(UnitOf::length, 3.085678e21), "kpc") << "as GADGET writes it";
  EXPECT_EQ(unit_name(UnitOf::mass, 1.989e43), "1e10 Msun") << "as GADGET writes it";
  EXPECT_EQ(unit_name(UnitOf::length, 10 * kpc), "10 kpc");
  EXPECT_EQ(unit_name(UnitOf::velocity, 1e5), "km/s");
  EXPECT_EQ(unit_name(UnitOf::time, kpc / 1e5), "977.79 Myr");  // 3.08568e16 s / 3.15576e13 s
  EXPECT_EQ(unit_name(UnitOf::length, 1), "cm");
  EXPECT_EQ(unit_name(UnitOf::mass, 3e-5), "3e-05 g");
  EXPECT_EQ(units_text(std::nullopt), "code units");
  EXPECT_EQ(units_text(Units{kpc, 1e10 * Msun, Gyr}), "kpc, 1e10 Msun, kpc/Gyr and Gyr");
}

TEST(Units, LabelsOfPictures) {
  const Units units{kpc, 1e10 * Msun, kpc / 1e5};
  EXPECT_EQ(unit_label(units, "x", 3, 1.4), "kpc");
  EXPECT_EQ(unit_label(units, "t", 3, 1.4), "977.79 Myr");
  EXPECT_EQ(unit_label(units, "rho", 3, 1.4), "1e10 Msun kpc^-3");
  EXPECT_EQ(unit_label(units, "rho", 2, 1.4), "1e10 Msun kpc^-2");
  EXPECT_EQ(unit_label(units, "P", 3, 1.4), "1e10 Msun kpc^-3 (km/s)^2");
  EXPECT_EQ(unit_label(units, "u", 3, 1.4), "(km/s)^2");
  EXPECT_EQ(unit_label(units, "A", 3, 1.4), "(km/s)^2 (1e10 Msun kpc^-3)^-0.4");  // A = P/rho^gamma
}

class UnitsOfFiles : public Scratch {
 protected:
  std::optional<Units> read(const std::optional<Units>& units) {
    SnapshotInfo info = example_info();
    info.units = units;
    write_snapshot(file("snap.hdf5"), example_snapshot(3, 5), info);
    return read_particles(file("snap.hdf5")).units;
  }
};

TEST_F(UnitsOfFiles, WriteAndReadIsTheIdentity) {
  const Units odd{3.085678e21, 1.989e43, 3.0857e16 / 3};
  EXPECT_EQ(read(odd), odd);
  EXPECT_EQ(read(Units{}), Units{}) << "cgs that somebody asked for";
  EXPECT_EQ(read(std::nullopt), std::nullopt);
}

/// What others multiply by: cgs of M L^-3 is mass over length cubed, of L t^-1 the velocity.
TEST_F(UnitsOfFiles, EveryDatasetSaysItsFactor) {
  const Units units{2, 3, 5};
  read(units);
  const auto written = hdf5::File::open(file("snap.hdf5"));
  const auto factor = [&](const char* name) {
    return written.group("PartType0")
        .dataset(name)
        .numbers("Conversion factor to CGS (not including cosmological corrections)")[0];
  };
  EXPECT_DOUBLE_EQ(factor("Coordinates"), 2);
  EXPECT_DOUBLE_EQ(factor("Masses"), 3);
  EXPECT_DOUBLE_EQ(factor("Velocities"), 2.0 / 5);
  EXPECT_DOUBLE_EQ(factor("Densities"), 3.0 / 8);
  EXPECT_DOUBLE_EQ(factor("InternalEnergies"), 4.0 / 25);
  EXPECT_DOUBLE_EQ(factor("Pressures"), 3.0 / (2 * 25));  // M L^-1 t^-2
  EXPECT_DOUBLE_EQ(factor("ParticleIDs"), 1);
  for (const char* group : {"Units", "InternalCodeUnits"}) {
    EXPECT_EQ(written.group(group).numbers("Unit length in cgs (U_L)")[0], 2);
    EXPECT_EQ(written.group(group).numbers("Unit mass in cgs (U_M)")[0], 3);
    EXPECT_EQ(written.group(group).numbers("Unit time in cgs (U_t)")[0], 5);
  }
}

}  // namespace
}  // namespace sphk
