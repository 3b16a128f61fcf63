// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_checksum_h
#define lahar_utilities_checksum_h

#include <string>

namespace Lahar
{
  /// CRC-32 of @p data.
  unsigned int checksum(const std::string &data);

  /// CRC-32 of what a file holds. @throws InputError if it cannot be read.
  unsigned int checksum_of_file(const std::string &file_name);
} // namespace Lahar

#endif
