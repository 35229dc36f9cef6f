#pragma once

#include "kernels/core/fields.hpp"

namespace sphk {

// Fields of the generalised family (R10 sec 3) and of V10.

/// The density of the generalised continuity equation, rho_i = sum_j m_j (eta_i/eta_j) W (R10 eq 19): what the
/// equations of motion use where a scheme has it. Observers use Density (R10 sec 3.5).
struct GeneralDensity {
  static constexpr const char* name = "GeneralDensities";
  template <class T, int D>
  struct Value {
    T rho_eta;
  };
};

/// d(rho/eta)/dh of it.
struct GeneralDensitySlope {
  static constexpr const char* name = "GeneralDensitySlopes";
  template <class T, int D>
  struct Value {
    T slope_eta;
  };
};

/// 1/eta, 1/phi and 1/zeta: the free functions of R10 eq 16-19.
struct InverseEta {
  static constexpr const char* name = "InverseEta";
  template <class T, int D>
  struct Value {
    T eta_inv;
  };
};
struct InversePhi {
  static constexpr const char* name = "InversePhi";
  template <class T, int D>
  struct Value {
    T phi_inv;
  };
};
struct InverseZeta {
  static constexpr const char* name = "InverseZeta";
  template <class T, int D>
  struct Value {
    T zeta_inv;
  };
};

/// P phi^2 / rho^2.
struct PhiPressure {
  static constexpr const char* name = "PhiPressures";
  template <class T, int D>
  struct Value {
    T P_phi2;
  };
};

/// P zeta / rho^2.
struct ZetaPressure {
  static constexpr const char* name = "ZetaPressures";
  template <class T, int D>
  struct Value {
    T P_zeta;
  };
};

/// sum_j m_j A_j rho_j^(gamma-1) Wbar (V10 eq 7).
struct SmoothedPressure {
  static constexpr const char* name = "SmoothedPressures";
  template <class T, int D>
  struct Value {
    T P_smooth;
  };
};

}  // namespace sphk
