// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/sha256.hpp"

#include <openssl/evp.h>

#include <array>
#include <memory>
#include <stdexcept>

namespace interphase {

std::string sha256(std::istream& stream)
{
    const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
    bool works = context && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
    std::array<char, 1 << 16> part;
    while (works && stream) {
        stream.read(part.data(), part.size());
        works = EVP_DigestUpdate(context.get(), part.data(), static_cast<std::size_t>(stream.gcount())) == 1;
    }
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned int length = 0;
    if (!works || EVP_DigestFinal_ex(context.get(), digest.data(), &length) != 1)
        throw std::runtime_error("OpenSSL gives no SHA-256 digest");

    constexpr char digits[] = "0123456789abcdef";
    std::string text;
    for (unsigned int k = 0; k < length; ++k)
        text += {digits[digest[k] >> 4], digits[digest[k] & 15]};
    return text;
}

}  // namespace interphase
