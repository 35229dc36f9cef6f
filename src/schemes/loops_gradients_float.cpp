#include "src/schemes/loops.hpp"

namespace sphk {

[[gnu::used]] static const auto line = gradient_loops<1, float>(AllSharedLoops{});
[[gnu::used]] static const auto plane = gradient_loops<2, float>(AllSharedLoops{});
[[gnu::used]] static const auto space = gradient_loops<3, float>(AllSharedLoops{});

}  // namespace sphk
