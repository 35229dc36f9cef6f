// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/core/fields.hpp"

namespace sphk {

// Fields of the generalised family (R10 sec 3) and of V10.

/// The density of the generalised continuity equation, rho_i = sum_j m_j (eta_i/eta_j) W (R10 eq 19): what the
/// equations of motion use where a scheme has it. Observers use Density (R10 sec 3.5).
struct GeneralDensity {
  static constexpr FieldFacts facts{.name = "GeneralDensities",
                                    .description = "Density of the equations of motion (R10 eq 19)",
                                    .unit = {.mass = 1, .volume = -1},
                                    .shown = Shown::in_snapshots,
                                    .singular = "GeneralDensity"};
  template <class T, int D>
  struct Value {
    T rho_eta;
  };
};

/// d(rho/eta)/dh of it.
struct GeneralDensitySlope {
  static constexpr FieldFacts facts{.name = "GeneralDensitySlopes", .description = "d(rho/eta)/dh"};
  template <class T, int D>
  struct Value {
    T slope_eta;
  };
};

/// 1/eta, 1/phi and 1/zeta: the free functions of R10 eq 16-19.
struct InverseEta {
  static constexpr FieldFacts facts{.name = "InverseEta", .description = "1/eta"};
  template <class T, int D>
  struct Value {
    T eta_inv;
  };
};
struct InversePhi {
  static constexpr FieldFacts facts{.name = "InversePhi", .description = "1/phi"};
  template <class T, int D>
  struct Value {
    T phi_inv;
  };
};
struct InverseZeta {
  static constexpr FieldFacts facts{.name = "InverseZeta", .description = "1/zeta"};
  template <class T, int D>
  struct Value {
    T zeta_inv;
  };
};

/// P phi^2 / rho^2.
struct PhiPressure {
  static constexpr FieldFacts facts{.name = "PhiPressures", .description = "P phi^2/rho^2"};
  template <class T, int D>
  struct Value {
    T P_phi2;
  };
};

/// P zeta / rho^2.
struct ZetaPressure {
  static constexpr FieldFacts facts{.name = "ZetaPressures", .description = "P zeta/rho^2"};
  template <class T, int D>
  struct Value {
    T P_zeta;
  };
};

/// sum_j m_j A_j rho_j^(gamma-1) Wbar (V10 eq 7).
struct SmoothedPressure {
  static constexpr FieldFacts facts{.name = "SmoothedPressures",
                                    .description = "Pressure smoothed over the neighbours (V10 eq 7)",
                                    .unit = {.length = 2, .mass = 1, .time = -2, .volume = -1}};
  template <class T, int D>
  struct Value {
    T P_smooth;
  };
};

}  // namespace sphk
