// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace sphk {

/// What figures need of Python, and what pages need.
inline const std::vector<std::string> packages_of_figures{"matplotlib"}, packages_of_pages{"matplotlib", "jinja2"};

/// Runs the drawing scripts that are shipped with sphk (src/python/sphk/figures) on `work` (JSON, on their standard
/// input); they print the names of the figures. Of the work "{}" nothing comes but to see that all is there.
/// Takes the first Python that has the packages: $SPHK_PYTHON,
/// /usr/bin/python3, python3 of the PATH. Throws InputError when there is none (with the packages to install) or when
/// the scripts fail.
void run_plot_script(const std::string& work, const std::vector<std::string>& packages = packages_of_figures);

}  // namespace sphk
