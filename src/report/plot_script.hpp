#pragma once

#include <string>

namespace sphk {

/// Runs the drawing script that is shipped with sphk on `work` (JSON, on its standard input); it prints the names of
/// the figures. Takes the first Python that has matplotlib and h5py: $SPHK_PYTHON, /usr/bin/python3, python3 of the
/// PATH. Throws InputError when there is none (with the packages to install) or when the script fails.
void run_plot_script(const std::string& work);

}  // namespace sphk
