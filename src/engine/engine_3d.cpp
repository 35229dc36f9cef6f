// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/engine.hpp"

namespace sphk {

[[gnu::used]] static const auto entropy_form = compiled_run<Layout<3, BaseFields, EntropyForm>>();
[[gnu::used]] static const auto energy_form = compiled_run<Layout<3, BaseFields, EnergyForm>>();

}  // namespace sphk
