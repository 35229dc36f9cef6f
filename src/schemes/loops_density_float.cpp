#include "src/schemes/loops.hpp"

namespace sphk {

[[gnu::used]] static const auto line = density_loops<1, float>(AllSharedLoops{});
[[gnu::used]] static const auto plane = density_loops<2, float>(AllSharedLoops{});
[[gnu::used]] static const auto space = density_loops<3, float>(AllSharedLoops{});

}  // namespace sphk
