// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/sha256.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace interphase {

namespace {

using Word = std::uint32_t;
using Block = std::array<unsigned char, 64>;

// Sections 4.2.2 and 5.3.3: fractional parts of the cube roots of the first 64 primes, and of the square roots of the
// first 8.
constexpr std::array<Word, 64> round_constants{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};
constexpr std::array<Word, 8> initial_state{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                            0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};

constexpr Word rotated(Word x, int bits) { return x >> bits | x << (32 - bits); }

/// Section 6.2.2.
void take(std::array<Word, 8>& state, const Block& block)
{
    std::array<Word, 64> schedule{};
    for (std::size_t t = 0; t < 16; ++t)
        for (std::size_t byte = 0; byte < 4; ++byte)
            schedule[t] = schedule[t] << 8 | block[4 * t + byte];
    for (std::size_t t = 16; t < 64; ++t) {
        const Word a = schedule[t - 15], b = schedule[t - 2];
        schedule[t] = schedule[t - 16] + schedule[t - 7] + (rotated(a, 7) ^ rotated(a, 18) ^ a >> 3) +
                      (rotated(b, 17) ^ rotated(b, 19) ^ b >> 10);
    }
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t t = 0; t < 64; ++t) {
        const Word first = h + (rotated(e, 6) ^ rotated(e, 11) ^ rotated(e, 25)) + ((e & f) ^ (~e & g)) +
                           round_constants[t] + schedule[t];
        const Word second = (rotated(a, 2) ^ rotated(a, 13) ^ rotated(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
        h = g;
        g = f;
        f = e;
        e = d + first;
        d = c;
        c = b;
        b = a;
        a = first + second;
    }
    const std::array<Word, 8> change{a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < state.size(); ++i)
        state[i] += change[i];
}

}  // namespace

std::string sha256(std::istream& stream)
{
    std::array<Word, 8> state = initial_state;
    Block block{};
    std::uint64_t bytes = 0;
    std::size_t filled = 0;
    const auto read = [&] {
        stream.read(reinterpret_cast<char*>(block.data()), static_cast<std::streamsize>(block.size()));
        filled = static_cast<std::size_t>(stream.gcount());
        bytes += filled;
        return filled == block.size();
    };
    while (read())
        take(state, block);

    // Section 5.1.1: a bit 1, zeros, and the length in bits fill the last block, or one more.
    block[filled++] = 0x80;
    if (filled > 56) {
        for (; filled < block.size(); ++filled)
            block[filled] = 0;
        take(state, block);
        filled = 0;
    }
    for (; filled < 56; ++filled)
        block[filled] = 0;
    for (int shift = 56; shift >= 0; shift -= 8)
        block[filled++] = static_cast<unsigned char>(8 * bytes >> shift);
    take(state, block);

    std::string digits;
    for (const Word word : state)
        for (int shift = 28; shift >= 0; shift -= 4)
            digits += "0123456789abcdef"[word >> shift & 15];
    return digits;
}

}  // namespace interphase
