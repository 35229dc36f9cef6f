#include "src/schemes/loops.hpp"

namespace sphk {

[[gnu::used]] static const auto line = error_loops<1>(ErrorKernels::in<1>{});
[[gnu::used]] static const auto plane = error_loops<2>(ErrorKernels::in<2>{});
[[gnu::used]] static const auto space = error_loops<3>(ErrorKernels::in<3>{});

}  // namespace sphk
