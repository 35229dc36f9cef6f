#include "src/engine/base_code.hpp"

SPHK_COMPILE_BASE(3, EntropyForm)
SPHK_COMPILE_BASE(3, EnergyForm)
