#include "src/engine/base_code.hpp"

SPHK_COMPILE_BASE(1, EntropyForm)
SPHK_COMPILE_BASE(1, EnergyForm)
