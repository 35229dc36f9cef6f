#include "src/engine/compile_base.hpp"

SPHK_COMPILE_BASE(1, EntropyForm)
SPHK_COMPILE_BASE(1, EnergyForm)
