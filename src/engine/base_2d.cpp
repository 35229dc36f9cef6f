#include "src/engine/compile_base.hpp"

SPHK_COMPILE_BASE(2, EntropyForm)
SPHK_COMPILE_BASE(2, EnergyForm)
