#include "src/engine/base_code.hpp"

SPHK_COMPILE_BASE(2, EntropyForm)
SPHK_COMPILE_BASE(2, EnergyForm)
