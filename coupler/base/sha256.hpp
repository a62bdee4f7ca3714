// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <istream>
#include <string>

namespace interphase {

/// SHA-256 (FIPS 180-4) of what is left in a stream: 64 hexadecimal digits, as the program sha256sum prints them. By
/// OpenSSL.
std::string sha256(std::istream& stream);

}  // namespace interphase
