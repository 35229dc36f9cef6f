// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace CLI {
class App;
}

namespace sphk {

struct Options;

// The commands, a file each: it adds its options to the command line and says what is done with them. What is done
// returns an exit code, or throws what current_failure() tells of.
void add_run(CLI::App& root, Options& o);
void add_list(CLI::App& root, Options& o);
void add_show(CLI::App& root, Options& o);
void add_info(CLI::App& root, Options& o);
void add_ic(CLI::App& root, Options& o);
void add_plot(CLI::App& root, Options& o);
void add_movie(CLI::App& root, Options& o);
void add_rates(CLI::App& root, Options& o);
void add_stability(CLI::App& root, Options& o);
void add_study(CLI::App& root, Options& o);
void add_gallery(CLI::App& root, Options& o);
void add_extremes(CLI::App& root, Options& o);
void add_tables(CLI::App& root, Options& o);

}  // namespace sphk
