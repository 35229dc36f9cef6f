// SPDX-License-Identifier: BSD-3-Clause
#include "src/report/number_files.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

// The format is that of numpy.lib.format, version 1.0: magic, length of the header, a dictionary, the numbers.
TEST(NumberFiles, AreWhatNumPyReads) {
  std::string path;
  {
    NumberFiles files;
    path = files.add(std::vector<double>{1, 2.5, -3, 4, 5, 6}, {2, 3});
    const std::string bytes = read_text(path);
    ASSERT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t header = 10 + static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
    EXPECT_EQ(header % 64, 0u);
    EXPECT_EQ(bytes[header - 1], '\n');
    EXPECT_NE(bytes.find("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3,), }"), std::string::npos);
    ASSERT_EQ(bytes.size(), header + 6 * sizeof(double));
    double second = 0;
    std::memcpy(&second, bytes.data() + header + sizeof(double), sizeof second);
    EXPECT_EQ(second, 2.5);
    const std::string image = read_text(files.add_image(std::vector<double>{0.5}, {1, 1}));
    EXPECT_EQ(image.substr(image.size() - 4), std::string("\0\0\0\x3f", 4)) << "0.5f";
  }
  EXPECT_FALSE(std::filesystem::exists(path)) << "they go with the object";
}

}  // namespace
}  // namespace sphk
