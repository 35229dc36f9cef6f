#include "src/engine/compile_base.hpp"

SPHK_COMPILE_BASE(3, EntropyForm)
SPHK_COMPILE_BASE(3, EnergyForm)
