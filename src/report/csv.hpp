// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sphk {

/// What a CSV file holds, as text.
struct CsvTable {
  struct Row {
    int line = 0;                     ///< of the file, from 1
    std::vector<std::string> values;  ///< as many as there are in this line
  };
  std::vector<std::string> columns;  ///< the names in the first line; none: the file holds no table
  std::vector<Row> rows;
};

/// Reads a file whose first line names the columns. Values may stand in quotation marks, doubled within; blanks around
/// values, empty lines and lines that begin with # do not count. Throws InputError where the file cannot be read.
CsvTable read_csv(const std::filesystem::path& path);

/// The values as a line, with its end: quotation marks where commas or such need them, no line break within.
std::string csv_line(const std::vector<std::string>& values);

}  // namespace sphk
