// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/checksum.h>
#include <lahar/utilities/exceptions.h>

#include <boost/crc.hpp>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

namespace Lahar
{
  unsigned int checksum(const std::string &data)
  {
    boost::crc_32_type crc;
    crc.process_bytes(data.data(), data.size());
    return crc.checksum();
  }



  unsigned int checksum_of_file(const std::string &file_name)
  {
    std::ifstream file(file_name, std::ios::binary);
    boost::crc_32_type crc;
    std::vector<char> block(1 << 20);
    while (file.read(block.data(), block.size()) || file.gcount() > 0)
      crc.process_bytes(block.data(), file.gcount());
    if (!file.eof())
      throw InputError("File '" + file_name + "' cannot be read: " + std::strerror(errno) + ".");
    return crc.checksum();
  }
} // namespace Lahar
