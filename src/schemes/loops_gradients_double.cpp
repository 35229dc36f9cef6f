#include "src/schemes/loops.hpp"

namespace sphk {

[[gnu::used]] static const auto line = gradient_loops<1, double>(AllSharedLoops{});
[[gnu::used]] static const auto plane = gradient_loops<2, double>(AllSharedLoops{});
[[gnu::used]] static const auto space = gradient_loops<3, double>(AllSharedLoops{});

}  // namespace sphk
