// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "src/engine/particle_set.hpp"

namespace sphk::test {

/// The values stay those of `fields`, which has to outlive them.
inline const std::vector<double>& named(const std::vector<Field>& fields, const std::string& name) {
  for (const Field& field : fields)
    if (field.name == name) return field.values;
  throw std::out_of_range("no field " + name);
}

inline std::vector<double> flat(const std::vector<Array3>& vectors) {
  std::vector<double> out;
  for (const Array3& v : vectors) out.insert(out.end(), v.begin(), v.end());
  return out;
}

/// Every value within `relative` of the largest one that is wanted.
inline void expect_near(const std::vector<double>& got, const std::vector<double>& wanted, double relative,
                        const char* what) {
  ASSERT_EQ(got.size(), wanted.size()) << what;
  double scale = 0;
  for (const double value : wanted) scale = std::max(scale, std::abs(value));
  for (std::size_t i = 0; i < got.size(); ++i) ASSERT_NEAR(got[i], wanted[i], relative * scale) << what << " of " << i;
}

}  // namespace sphk::test
