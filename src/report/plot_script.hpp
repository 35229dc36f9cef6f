#pragma once

#include <string>
#include <vector>

namespace sphk {

/// Runs the drawing scripts that are shipped with sphk (src/python/sphk/figures) on `work` (JSON, on their standard
/// input); they print the names of the figures. Takes the first Python that has the packages: $SPHK_PYTHON,
/// /usr/bin/python3, python3 of the PATH. Throws InputError when there is none (with the packages to install) or when
/// the scripts fail.
void run_plot_script(const std::string& work, const std::vector<std::string>& packages = {"matplotlib", "h5py"});

}  // namespace sphk
